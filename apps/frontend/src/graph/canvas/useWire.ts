import { computed, type ComputedRef } from 'vue';
import { DATA_FORMATS, type DataFormatFamily } from '@ubii/proto';
import { isAlive } from '../../sessions/state/session-state.ts';
import { useGraphContext } from '../live/useGraphContext.ts';
import { useCanvas } from './useCanvas.ts';
import type { LiveTopic } from '../live/live-topic.ts';
import { topicOfWire } from '../live/topics-in-graph.ts';
import type { Point, Wire } from '../model/graph.ts';
import { portFormat, portOf } from '../model/port-format.ts';
import type { CanvasStage } from './canvas-stage.ts';
import { overlaps } from './seen-area.ts';
import { wireBox, wirePath, type WirePath } from './wire-path.ts';

/** Current appearance of a wire. */
export interface WireLook {
  /** Undefined while the wire is off the screen. */
  readonly path: ComputedRef<WirePath | undefined>;
  readonly family: ComputedRef<DataFormatFamily>;
  readonly isList: ComputedRef<boolean>;
  readonly live: ComputedRef<LiveTopic | undefined>;
  /** The session runs, and the topic of the wire has no value. */
  readonly isIdle: ComputedRef<boolean>;
  /** Current bend points, also while they are dragged. */
  readonly points: ComputedRef<readonly Point[]>;
  readonly isSelected: ComputedRef<boolean>;
  /** True while another node or wire is highlighted. */
  readonly isDim: ComputedRef<boolean>;
}

/** Whether a wire is on the screen or close to it. */
export function isWireSeen(stage: CanvasStage, wire: Wire): boolean {
  const ends = endsOf(stage, wire);
  return ends !== undefined && overlaps(wireBox(...ends, wire.points), stage.area.value);
}

function endsOf(stage: CanvasStage, { from, to }: Wire): readonly [Point, Point] | undefined {
  const [start, end] = [stage.socketAt(from, 'out'), stage.socketAt(to, 'in')];
  return start && end && [start, end];
}

export function useWire(wire: () => Wire): WireLook {
  const { editor, live } = useGraphContext();
  const { stage, gesture, drag, points: wirePoints } = useCanvas();
  const format = computed(() => {
    const { from, to } = wire();
    const graph = editor.graph.value;
    return portFormat(graph, from) ?? portFormat(graph, to);
  });
  const topic = computed(() => topicOfWire(editor.graph.value, wire()));
  const now = computed(() => (topic.value === undefined ? undefined : live.topic(topic.value)));
  const isSelected = computed(() => editor.selection.value.wire === wire().id);
  const points = computed(() => {
    const { id, points: own } = wire();
    const shown = wirePoints.shown.value;
    if (shown?.wire === id) return shown.points;
    if (own.length === 0 || !drag.taken.value.has(id)) return own;
    const by = drag.by.value;
    return own.map(({ x, y }) => ({ x: x + by.x, y: y + by.y }));
  });
  const ends = computed(() => endsOf(stage, wire()));
  const isSeen = computed(
    () => ends.value && overlaps(wireBox(...ends.value, points.value), stage.area.value),
  );
  return {
    path: computed(() =>
      ends.value && isSeen.value ? wirePath(...ends.value, points.value) : undefined,
    ),
    points,
    family: computed(() => (format.value ? DATA_FORMATS[format.value].family : 'system')),
    isList: computed(() => portOf(editor.graph.value, wire().from)?.isList === true),
    live: now,
    isIdle: computed(
      () => topic.value !== undefined && now.value === undefined && isAlive(editor.session.value),
    ),
    isSelected,
    isDim: computed(() => {
      const { nodes, wire: selected } = editor.selection.value;
      const { from, to, id } = wire();
      if (gesture.pull.value !== undefined) return gesture.pull.value.moving?.id === id;
      if (selected !== undefined) return selected !== id;
      return nodes.size > 0 && !nodes.has(from.node) && !nodes.has(to.node);
    }),
  };
}
