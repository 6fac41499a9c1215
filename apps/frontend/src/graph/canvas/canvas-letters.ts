/** Letters that are commands on the canvas of a graph, in upper case. `canvas-keys.ts` handles them. */
export const CANVAS_LETTERS = 'ABCFILMPRWX';
