/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Instances of the initial fields, and their entries in the selection tables.

\*---------------------------------------------------------------------------*/

#include "initialField.H"
#include "uniformInitialField.H"
#include "linearInitialField.H"
#include "profileInitialField.H"
#include "codedInitialField.H"
#include "exactInitialField.H"
#include "hydrostaticInitialField.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

#define makeInitialField(Type)                                                 \
                                                                               \
    defineNamedTemplateTypeNameAndDebug(initialField<Type>, 0);                \
    defineTemplateRunTimeSelectionTable(initialField<Type>, dictionary);

#define makeInitialFieldType(SS, Type)                                         \
                                                                               \
    typedef initialFields::SS<Type> SS##Type##InitialField;                    \
    defineTemplateTypeNameAndDebugWithName(SS##Type##InitialField, #SS, 0);    \
    initialField<Type>::adddictionaryConstructorToTable                        \
        <SS##Type##InitialField> add##SS##Type##InitialFieldToTable_;

#define makeInitialFields(Type)                                                \
                                                                               \
    makeInitialField(Type)                                                     \
    makeInitialFieldType(uniform, Type)                                        \
    makeInitialFieldType(linear, Type)                                         \
    makeInitialFieldType(profile, Type)                                        \
    makeInitialFieldType(coded, Type)                                          \
    makeInitialFieldType(exact, Type)                                          \
                                                                               \
    template class initialField<Type>;                                         \
    template class initialFields::uniform<Type>;                               \
    template class initialFields::linear<Type>;                                \
    template class initialFields::profile<Type>;                               \
    template class initialFields::coded<Type>;                                 \
    template class initialFields::exact<Type>;


namespace Foam
{
    makeInitialFields(scalar)
    makeInitialFields(vector)

    namespace initialFields
    {
        defineTypeNameAndDebug(hydrostatic, 0);
    }

    initialField<scalar>::adddictionaryConstructorToTable
        <initialFields::hydrostatic> addhydrostaticInitialFieldToTable_;
}


// ************************************************************************* //
