import type { DataFormat, JsonValue } from '@ubii/proto';
import { onScopeDispose, ref, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import {
  framesDue,
  lengthMs,
  MAX_VALUE_LENGTH,
  placeAt,
  withFrame,
  type Gesture,
  type Place,
  type PlayMode,
} from './gesture.ts';

/** Interval at which due values are sent, milliseconds. */
const LOOK_MS = 10;

/** Records how a value changes over time, and plays the recording. */
export interface GestureDeck {
  /** `waiting`: recording starts with the next change. */
  readonly state: Readonly<Ref<'idle' | 'waiting' | 'recording' | 'playing'>>;
  readonly gesture: Readonly<ShallowRef<Gesture | undefined>>;
  /** Position within the gesture while recording or playing, milliseconds. */
  readonly atMs: Readonly<Ref<number>>;
  readonly problem: Readonly<ShallowRef<string | undefined>>;
  readonly fromMs: Ref<number>;
  readonly toMs: Ref<number>;
  readonly speed: Ref<string>;
  readonly mode: Ref<PlayMode>;
  record(): void;
  play(): void;
  stop(): void;
  open(gesture: Gesture | undefined): void;
}

/**
 * @param value recorded whenever it changes
 * @param send publishes a value of the gesture; playing stops when it returns false
 */
export function useGesture(
  format: () => DataFormat,
  value: () => JsonValue | undefined,
  send: (format: DataFormat, value: JsonValue) => boolean,
): GestureDeck {
  const state = ref<'idle' | 'waiting' | 'recording' | 'playing'>('idle');
  const gesture = shallowRef<Gesture>();
  const atMs = ref(0);
  const problem = shallowRef<string>();
  const fromMs = ref(0);
  const toMs = ref(0);
  const speed = ref('1');
  const mode = ref<PlayMode>('loop');
  let timer: ReturnType<typeof setInterval> | undefined;
  let startMs = 0;
  /** Position at the last check; `undefined` at the start. */
  let before: Place | undefined;

  function stop(): void {
    clearInterval(timer);
    const wasRecording = state.value === 'recording';
    state.value = 'idle';
    if (wasRecording && gesture.value) {
      fromMs.value = 0;
      toMs.value = lengthMs(gesture.value);
    }
    atMs.value = fromMs.value;
  }
  onScopeDispose(stop);

  function add(json: JsonValue): void {
    const now = performance.now();
    if (state.value === 'waiting') {
      startMs = now;
      gesture.value = { format: format(), frames: [] };
      state.value = 'recording';
    }
    const next = withFrame(gesture.value!, Math.round(now - startMs), json);
    if (next) gesture.value = next;
    else stop();
  }
  watch(value, (json) => {
    if (json === undefined || (state.value !== 'waiting' && state.value !== 'recording')) return;
    if (JSON.stringify(json).length > MAX_VALUE_LENGTH) {
      stop();
      problem.value = 'This value is too large for a gesture.';
    } else add(json);
  });
  watch(format, () => {
    if (state.value === 'waiting' || state.value === 'recording') stop();
  });

  function look(): void {
    const playing = {
      fromMs: fromMs.value,
      toMs: toMs.value,
      speed: Number(speed.value),
      mode: mode.value,
    };
    const place = placeAt(playing, performance.now() - startMs);
    const due = framesDue(gesture.value!, before, place, playing);
    before = place;
    atMs.value = place.atMs;
    for (const frame of due) {
      if (!send(gesture.value!.format, frame.value)) return stop();
    }
    if (place.isOver) stop();
  }

  // A change of speed or trim restarts the gesture: the position would jump otherwise.
  watch([speed, mode, fromMs, toMs], () => state.value === 'playing' && play());
  function play(): void {
    stop();
    problem.value = undefined;
    if (!gesture.value) return;
    state.value = 'playing';
    startMs = performance.now();
    before = undefined;
    timer = setInterval(look, LOOK_MS);
    look();
  }

  return {
    state,
    gesture,
    atMs,
    problem,
    fromMs,
    toMs,
    speed,
    mode,
    record() {
      stop();
      problem.value = undefined;
      gesture.value = undefined;
      atMs.value = 0;
      state.value = 'waiting';
    },
    play,
    stop,
    open(next) {
      stop();
      problem.value = undefined;
      gesture.value = next;
      fromMs.value = 0;
      toMs.value = next ? lengthMs(next) : 0;
      atMs.value = 0;
    },
  };
}
