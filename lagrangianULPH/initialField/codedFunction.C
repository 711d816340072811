/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "codedFunction.H"
#include "dynamicCode.H"
#include "dynamicCodeContext.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
std::string Foam::codedFunction<Type>::source
(
    const std::string& include,
    const std::string& localCode,
    const std::string& code,
    const word& functionName
)
{
    const std::string type(pTraits<Type>::typeName);

    return
        "#include \"point.H\"\n"
        "#include \"tensor.H\"\n"
        "#include \"mathematicalConstants.H\"\n"
        "#include \"unitConversion.H\"\n"
      + include + "\n"
        "namespace Foam\n{\n"
      + localCode + "\n"
        "static " + type + " valueAt\n"
        "(\n"
        "    const point& position,\n"
        "    [[maybe_unused]] const scalar time\n"
        ")\n{\n"
      + code + "\n}\n}\n"
        "extern \"C\" void " + functionName + "\n"
        "(\n"
        "    const Foam::scalar time,\n"
        "    const Foam::point* positions,\n"
        "    Foam::" + type + "* values,\n"
        "    const Foam::label n\n"
        ")\n{\n"
        "    for (Foam::label i = 0; i < n; ++i)\n"
        "    {\n"
        "        values[i] = Foam::valueAt(positions[i], time);\n"
        "    }\n}\n";
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::codedFunction<Type>::codedFunction
(
    const dictionary& dict
)
:
    evaluate_(nullptr)
{
    dynamicCode::checkSecurity("codedFunction", dict);

    const dynamicCodeContext context(dict);
    const word name
    (
        "coded_" + word(pTraits<Type>::typeName) + context.sha1().str(true)
    );

    dynamicCode library(name);
    bool made = true;

    if (Pstream::master() && !isFile(library.libPath(), false))
    {
        library.reset(context);
        library.addCreateFile
        (
            "codedFunction.C",
            source(context.include(), context.localCode(), context.code(), name)
        );
        library.addCreateFile
        (
            "Make/files",
            "codedFunction.C\n\n"
            "LIB = $(PWD)/../platforms/$(WM_OPTIONS)/lib/lib" + name
        );
        library.addCreateFile
        (
            "Make/options",
            "EXE_INC = \\\n" + context.options()
          + "\n\nLIB_LIBS = \\\n" + context.libs()
        );

        made = library.copyOrCreateFiles(true) && library.wmakeLibso();
    }

    reduce(made, andOp<bool>());

    void* handle = made ? dlOpen(library.libPath()) : nullptr;

    if (handle)
    {
        evaluate_ = reinterpret_cast<evaluator>(dlSymFind(handle, name));
    }

    if (!evaluate_)
    {
        FatalIOErrorInFunction(dict)
            << "Could not compile or load the code of this field." << nl
            << "The compiler's messages are above, its input in "
            << library.codePath() << nl
            << exit(FatalIOError);
    }
}


// ************************************************************************* //
