import { shallowRef, type ShallowRef } from 'vue';
import type { Graph, GraphNode, Point, Wire } from '../../model/graph.ts';
import { wiresToInsertOn } from '../../model/selection/insert.ts';
import type { InsertPlace } from '../../model/selection/drop-nodes.ts';
import type { CanvasStage } from '../canvas-stage.ts';
import { nearestOn, spotsOf, type NearSpot, type WireSpot } from '../wire-hit.ts';

/** Points along a wire as drawn now; none when one of its ends is not on the stage. */
export function spotsOnStage(
  stage: Pick<CanvasStage, 'socketAt'>,
  { from, to, points }: Wire,
): readonly WireSpot[] {
  const [start, end] = [stage.socketAt(from, 'out'), stage.socketAt(to, 'in')];
  return start && end ? spotsOf(start, end, points) : [];
}

/** Wire that a dragged node would be inserted into. */
export class InsertTarget {
  /** Id of the highlighted wire; undefined: none. */
  readonly wire: ShallowRef<string | undefined> = shallowRef();
  #leg = 0;
  readonly #stage: Pick<CanvasStage, 'socketAt'>;
  #candidates: readonly { readonly id: string; readonly spots: readonly WireSpot[] }[] = [];

  constructor(stage: Pick<CanvasStage, 'socketAt'>) {
    this.#stage = stage;
  }

  /** Starts the drag of a node, which need not be in the graph. Wires it does not fit are ignored. */
  begin(graph: Graph, node: GraphNode): void {
    this.#candidates = wiresToInsertOn(graph, node).map((wire) => ({
      id: wire.id,
      spots: spotsOnStage(this.#stage, wire),
    }));
  }

  /** Highlights the nearest wire. @param reach largest distance, in canvas units */
  over(place: Point, reach: number): void {
    let best: (NearSpot & { readonly id: string }) | undefined;
    for (const { id, spots } of this.#candidates) {
      const spot = nearestOn(spots, place);
      if (spot !== undefined && spot.distance <= (best?.distance ?? reach)) best = { ...spot, id };
    }
    this.wire.value = best?.id;
    this.#leg = best?.leg ?? 0;
  }

  /** @returns the last place over a wire */
  end(): InsertPlace | undefined {
    const wire = this.wire.value;
    this.wire.value = undefined;
    this.#candidates = [];
    return wire === undefined ? undefined : { wire, leg: this.#leg };
  }
}
