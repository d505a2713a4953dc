namespace dobra::surf::remesh {}
