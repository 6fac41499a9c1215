import { useMediaQuery } from '@vueuse/core';
import { computed, ref, shallowReactive, watch, type ComputedRef, type Ref } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { isAlive } from '../../sessions/state/session-state.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';
import type { LiveGraph } from './live-graph.ts';
import { isOwnTouch } from './phone-topics.ts';

/** Touch pad below a session that reads the touch of this device. */
export interface OwnPad {
  readonly isOffered: ComputedRef<boolean>;
  /** Set to open or close it; overrides the default from then on. */
  readonly isOpen: Ref<boolean>;
  /** Whether a topic has no value only because the pad is not touched. */
  isResting(topic: string): boolean;
}

export interface PadSources {
  /** True on devices with a touchscreen. */
  readonly isTouch: Readonly<Ref<boolean>>;
  /** True on phones with enough height for the pad below the list. */
  readonly isPhone: Readonly<Ref<boolean>>;
  isRunning(): boolean;
  /** Topics in the graph with the touch of this device. */
  ownTouches(): readonly string[];
  /** Whether the topic has or had a value. */
  isPublished(topic: string): boolean;
}

export function createOwnPad(sources: PadSources): OwnPad {
  /** The user's choice; undefined: open when the session needs it. */
  const choice = ref<boolean>();
  const touches = computed(() => sources.ownTouches());
  const isOffered = computed(() => sources.isTouch.value && touches.value.length > 0);
  const isOpen = computed({
    get: () => isOffered.value && (choice.value ?? (sources.isPhone.value && sources.isRunning())),
    set: (open) => (choice.value = open),
  });
  // The master deletes the values of a closed pad, so remember that there were some.
  const touched = shallowReactive(new Set<string>());
  watch(
    () => touches.value.filter((topic) => sources.isPublished(topic)),
    (published) => published.forEach((topic) => touched.add(topic)),
    { immediate: true },
  );
  return {
    isOffered,
    isOpen,
    isResting: (topic) =>
      isOffered.value &&
      touches.value.includes(topic) &&
      (isOpen.value || touched.has(topic) || sources.isPublished(topic)),
  };
}

export function useOwnPad(editor: GraphEditor, live: LiveGraph): OwnPad {
  const { client, isConnected } = useConnection();
  const ownTouches = computed(() => {
    // The client id may change with a reconnect.
    void isConnected.value;
    return [...editor.graph.value.nodes.values()].flatMap((node) =>
      node.kind === 'topic' && isOwnTouch(node.topic, client.id) ? [node.topic] : [],
    );
  });
  return createOwnPad({
    isTouch: useMediaQuery('(pointer: coarse)'),
    isPhone: useMediaQuery('(max-width: 759px) and (min-height: 600px)'),
    isRunning: () => isAlive(editor.session.value),
    ownTouches: () => ownTouches.value,
    isPublished: (topic) => live.topic(topic)?.ageMs !== undefined,
  });
}
