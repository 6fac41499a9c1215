/** Id of the canvas, or of the list that replaces it: the target of the graph page's skip link. */
export const GRAPH_CANVAS_ID = 'graph-canvas';
