/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactInitialField.H"
#include "fvMesh.H"

#include <type_traits>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::initialFields::exact<Type>::exact
(
    const dictionary& dict,
    const initialRegion& region
)
:
    flow_
    (
        exactField::New
        (
            dict,
            region.time.lookupObject<fvMesh>(fvMesh::defaultRegion)
           .lookupObject<ulphCloud>(ulphCloud::cloudName)
        )
    )
{
    flow_->setTime(region.time.value());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::initialFields::exact<Type>::value
(
    const UList<point>& positions
) const
{
    auto tvalues = tmp<Field<Type>>::New(positions.size());

    forAll(positions, i)
    {
        if constexpr (std::is_same_v<Type, vector>)
        {
            tvalues.ref()[i] = flow_->U(positions[i]);
        }
        else
        {
            tvalues.ref()[i] = flow_->p(positions[i]);
        }
    }

    return tvalues;
}


// ************************************************************************* //
