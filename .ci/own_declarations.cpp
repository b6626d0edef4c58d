// A plug-in of clang-tidy: its checks look at our own declarations, not at those of system headers, whose findings
// are dropped anyway. With the headers of Qt or of a JSON library that is most of the time.
#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>

namespace {

namespace tidy = clang::tidy;
namespace matchers = clang::ast_matchers;

/// The translation unit is matched before what it holds: the scope set here is the one that is visited then.
class OwnDeclarations : public tidy::ClangTidyCheck {
public:
    using ClangTidyCheck::ClangTidyCheck;

    void registerMatchers(matchers::MatchFinder* finder) override
    {
        finder->addMatcher(matchers::translationUnitDecl(), this);
    }

    void check(const matchers::MatchFinder::MatchResult& result) override
    {
        const clang::SourceManager& sources = *result.SourceManager;
        std::vector<clang::Decl*> own;
        for (clang::Decl* declaration : result.Context->getTranslationUnitDecl()->decls())
            if (!sources.isInSystemHeader(sources.getExpansionLoc(declaration->getLocation())))
                own.push_back(declaration);
        result.Context->setTraversalScope(own);
    }
};

class Module : public tidy::ClangTidyModule {
public:
    void addCheckFactories(tidy::ClangTidyCheckFactories& factories) override
    {
        factories.registerCheck<OwnDeclarations>("lathelier-own-declarations");
    }
};

const tidy::ClangTidyModuleRegistry::Add<Module> added("lathelier", "Scope of the checks.");

}  // namespace
