import { useEventListener } from '@vueuse/core';
import { isSingleKeyShortcut } from '../../ui/keys/single-key.ts';
import { useSingleKeyShortcuts } from '../../ui/keys/useSingleKeyShortcuts.ts';
import type { Timeline } from './useTimeline.ts';

const SECOND_MS = 1000;
/** One frame where the recording has no pictures, milliseconds. */
const FRAME_MS = 40;
/** These use arrow keys and Space themselves. */
const OWN_KEYS = '[role="radiogroup"], [role="slider"], [role="scrollbar"], [role="combobox"]';
/** Space presses these. A link is not one of them: it may be the one that opened the recording. */
const PRESSABLE = 'button, summary, [role="button"]';

/** Keys of the timeline. @param mark adds a marker at the playhead */
export function useTimelineKeys(timeline: Timeline, mark: () => void): void {
  const isEnabled = useSingleKeyShortcuts();
  const { opened } = timeline;

  function step(direction: 1 | -1, isFrame: boolean): void {
    const frames = timeline.shown.value.find(({ kind }) => kind === 'frames');
    const track = isFrame ? frames : timeline.selected.value;
    if (track) opened.stepRecord(track.topic, direction);
    else opened.stepTime(direction * FRAME_MS);
  }
  const does: Readonly<Record<string, (isShifted: boolean) => void>> = {
    ' ': () => opened.togglePlay(),
    ArrowLeft: (isShifted) => (isShifted ? opened.stepTime(-SECOND_MS) : step(-1, false)),
    ArrowRight: (isShifted) => (isShifted ? opened.stepTime(SECOND_MS) : step(1, false)),
    ',': () => step(-1, true),
    '.': () => step(1, true),
    i: () => timeline.setLoopEdge('from'),
    o: () => timeline.setLoopEdge('until'),
    m: mark,
    '0': () => timeline.fit(),
  };
  useEventListener(window, 'keydown', (event: KeyboardEvent) => {
    if (!isEnabled.value || !isSingleKeyShortcut(event)) return;
    const { target } = event;
    if (target instanceof Element && target.closest(OWN_KEYS)) return;
    if (event.key === ' ' && target instanceof Element && target.closest(PRESSABLE)) return;
    const act = does[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (act === undefined) return;
    event.preventDefault();
    act(event.shiftKey);
  });
}
