import type { Size } from '../model/graph.ts';

/** Smallest canvas with a minimap, pixels; on smaller ones it would cover too much of the graph. */
const ROOMY: Size = { width: 760, height: 440 };
/** The minimap with its distance from the border and from nodes, pixels. */
const CORNER: Size = { width: 186, height: 184 };

/** True for canvases that have a minimap. */
export const hasMap = ({ width, height }: Size): boolean =>
  width >= ROOMY.width && height >= ROOMY.height;

/** Returns what the minimap covers in the right bottom corner of a canvas. */
export const mapCorner = (viewport: Size): Size | undefined =>
  hasMap(viewport) ? CORNER : undefined;
