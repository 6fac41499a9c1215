import { shallowRef, type ShallowRef } from 'vue';
import type { Graph, GraphNode, Point, Wire } from '../../model/graph.ts';
import { wiresToInsertOn } from '../../model/selection/insert.ts';
import type { CanvasStage } from '../canvas-stage.ts';
import { nearestOn, spotsOf, type WireSpot } from '../wire-hit.ts';

/** Places on a wire as it is drawn now; none when one of its ends is not on the stage. */
export function spotsOnStage(
  stage: Pick<CanvasStage, 'socketAt'>,
  { from, to, points }: Wire,
): readonly WireSpot[] {
  const [start, end] = [stage.socketAt(from, 'out'), stage.socketAt(to, 'in')];
  return start && end ? spotsOf(start, end, points) : [];
}

/** The wire that would take in what is being dragged over it. */
export class InsertTarget {
  /** Lit; undefined: none. */
  readonly wire: ShallowRef<string | undefined> = shallowRef();
  readonly #stage: Pick<CanvasStage, 'socketAt'>;
  #candidates: readonly { readonly id: string; readonly spots: readonly WireSpot[] }[] = [];

  constructor(stage: Pick<CanvasStage, 'socketAt'>) {
    this.#stage = stage;
  }

  /** A node begins to be dragged; it need not be in the graph. Other wires stay where they are. */
  begin(graph: Graph, node: GraphNode): void {
    this.#candidates = wiresToInsertOn(graph, node).map((wire) => ({
      id: wire.id,
      spots: spotsOnStage(this.#stage, wire),
    }));
  }

  /** Lights the nearest wire. @param reach how far off it may be, in units of the canvas */
  over(place: Point, reach: number): void {
    let best: { id: string; distance: number } | undefined;
    for (const { id, spots } of this.#candidates) {
      const distance = nearestOn(spots, place)?.distance ?? Infinity;
      if (distance <= Math.min(reach, best?.distance ?? reach)) best = { id, distance };
    }
    this.wire.value = best?.id;
  }

  /** @returns the wire it was over at last */
  end(): string | undefined {
    const wire = this.wire.value;
    this.wire.value = undefined;
    this.#candidates = [];
    return wire;
  }
}
