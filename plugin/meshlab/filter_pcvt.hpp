#pragma once

#include <common/interfaces.h>

#include <string>

#include "plugin/meshlab/tile_request.hpp"

/// "Create Periodic CVT Tile": a new layer with the tile of a periodic CVT.
///
/// The report of a run and its errors go to MeshLab's log. A host cancels a run by returning false
/// from its progress callback, which MeshLab 2020.09 never does; then no layer is added.
class FilterPcvt : public QObject, public MeshFilterInterface {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID MESH_FILTER_INTERFACE_IID)
    Q_INTERFACES(MeshFilterInterface)

   public:
    FilterPcvt();

    QString pluginName() const override;
    QString filterName(FilterIDType filter) const override;
    QString filterInfo(FilterIDType filter) const override;
    QString filterScriptFunctionName(FilterIDType filter) override;
    FilterClass getClass(QAction* action) override;
    FILTER_ARITY filterArity(QAction* action) const override;
    /// Nothing: existing layers do not change.
    int postCondition(QAction* action) const override;
    void initParameterSet(QAction* action, MeshDocument& document,
                          RichParameterList& parameters) override;
    bool applyFilter(QAction* action, MeshDocument& document, const RichParameterList& parameters,
                     vcg::CallBackPos* callback) override;

   private:
    void create_tile(MeshDocument& document, const pcvt::meshlab::TileRequest& request,
                     vcg::CallBackPos* callback);
    void report(const pcvt_result* result, const pcvt_tile& tile);
    void say(const std::string& line);
};
