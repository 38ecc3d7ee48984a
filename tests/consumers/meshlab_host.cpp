// A host of MeshLab's plugins that cancels filters, which MeshLab 2020.09 itself never does.
//   meshlab_host PLUGIN.so    exit 0: all claims hold; 1: the message names the one that fails
#include <common/interfaces.h>

#include <QPluginLoader>
#include <cstdio>
#include <string>
#include <vector>

namespace {

std::vector<int> g_percents;
std::size_t g_calls_before_cancel = 0;

bool note_progress(int percent, const char* text) {
    g_percents.push_back(percent);
    return std::string(text).find("residual") != std::string::npos &&
           g_percents.size() != g_calls_before_cancel;
}

void require(bool holds, const char* promise) {
    if (holds) return;
    std::printf("broken: %s\n", promise);
    std::exit(1);
}

bool apply(MeshFilterInterface& filter, MeshDocument& document, const char* lattice,
           vcg::CallBackPos* callback) {
    QAction* action = filter.AC("Create Periodic CVT Tile");
    RichParameterList parameters;
    filter.initParameterSet(action, document, parameters);
    parameters.setValue("lattice", StringValue(lattice));
    filter.setLog(&document.Log);
    g_percents.clear();
    return filter.applyFilter(action, document, parameters, callback);
}

void check_cancel(MeshFilterInterface& filter) {
    MeshDocument document;
    g_calls_before_cancel = 3;
    require(!apply(filter, document, "1, 0, 0.3, 0.9", note_progress), "a cancelled filter fails");
    require(g_percents.size() == 3, "nothing is reported after the callback cancels");
    require(filter.errorMsg() == "cancelled", "the message says cancelled");
    require(document.size() == 0, "a cancelled filter adds no layer");
    g_calls_before_cancel = 0;
}

void check_progress(MeshFilterInterface& filter) {
    MeshDocument document;
    require(apply(filter, document, "1, 0.5", note_progress),
            "a filter that is not cancelled succeeds");
    require(std::is_sorted(g_percents.begin(), g_percents.end()), "progress never goes back");
    require(g_percents.front() >= 0 && g_percents.back() > 60 && g_percents.back() <= 100,
            "progress is a percentage and comes near 100");
    require(document.size() == 1 && document.mm() == document.meshList[0],
            "one layer is added and becomes current");
}

void check_without_callback(MeshFilterInterface& filter) {
    MeshDocument document;
    require(apply(filter, document, "1 1", nullptr), "no callback is needed");
    require(!apply(filter, document, "1, 0, 1", nullptr), "three numbers are not a lattice");
    require(filter.errorMsg().contains("'1, 0, 1'"), "the message names the text");
    require(!apply(filter, document, "1, 1x", nullptr), "1x is not a number");
    require(filter.errorMsg().contains("'1x'"), "the message names the word");
    require(document.size() == 1, "a failing filter adds no layer");
}

}  // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    QPluginLoader loader(argv[1]);
    auto* filter = qobject_cast<MeshFilterInterface*>(loader.instance());
    require(filter != nullptr, qPrintable(loader.errorString()));
    check_cancel(*filter);
    check_progress(*filter);
    check_without_callback(*filter);
    return 0;
}
