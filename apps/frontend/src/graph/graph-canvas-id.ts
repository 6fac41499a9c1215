/** The element of the canvas: where the skip link of the graph page leads. */
export const GRAPH_CANVAS_ID = 'graph-canvas';
