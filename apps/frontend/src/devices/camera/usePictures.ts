import type { Image2D } from '@ubii/proto';
import { useDocumentVisibility, useIntervalFn } from '@vueuse/core';
import { onScopeDispose, shallowReactive, watch } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { RateMeter, SHOWN_WINDOW_MS } from '../sensors/rate-meter.ts';
import { adaptationWords } from './adapt/adaptation-words.ts';
import { adaptedStep, adaptPictures, FIRST_STATE } from './adapt/adapt-pictures.ts';
import { PictureMeter } from './adapt/picture-meter.ts';
import {
  affordableRate,
  PictureEncoder,
  type PictureSettings,
  type PictureSource,
} from './encode-picture.ts';
import { pictureClock } from './picture-clock.ts';
import { pictureExpiryMs, type PictureHabits } from './picture-habits.ts';

/** Measurements of the last pictures; all `undefined` while none are sent. */
export interface PictureMeasures {
  width: number | undefined;
  height: number | undefined;
  bytes: number | undefined;
  /** Time for drawing, scaling and packing a picture, milliseconds. */
  encodeMs: number | undefined;
  /** Time until the operating system accepted it, milliseconds. */
  leaveMs: number | undefined;
  rateHz: number | undefined;
  /** True when the rate is reduced to the highest data rate. */
  isSlowed: boolean;
  /** Difference from the wanted settings, and its reason, one sentence. */
  adapted: string | undefined;
  /** Time at which the last picture was sent, on the clock of `performance.now()`. */
  sentAtMs: number | undefined;
}

/** Timing and expiry of an encoded picture. */
export interface TakenPicture {
  /** Time from the exposure to the encoder, milliseconds; `undefined` where the browser does not report it. */
  readonly captureMs: number | undefined;
  readonly encodeMs: number;
  /** Age of the picture, milliseconds. */
  readonly ageMs: number;
  /** Expiry on the master without a newer picture; 0: until the client leaves. [TD-49] */
  readonly expiryMs: number;
}

const NOTHING: PictureMeasures = {
  width: undefined,
  height: undefined,
  bytes: undefined,
  encodeMs: undefined,
  leaveMs: undefined,
  rateHz: undefined,
  isSlowed: false,
  adapted: undefined,
  sentAtMs: undefined,
};

/** Interval of decisions about settings, milliseconds. */
const DECIDE_MS = 500;
/** Time after a disconnect or in the background during which measurements are outdated, milliseconds. */
const CALM_MS = 4000;
/** Interval between decisions from which the page was delayed, milliseconds. */
const LATE_MS = 1.8 * DECIDE_MS;
/** Interval of checks whether a picture was sent, for which WebSocket has no event, milliseconds. */
const LEAVE_POLL_MS = 4;
/** Share of a picture still in the buffer below which it counts as sent. */
const LEFT_SHARE = 0.1;
/** Number of round trips for the minimum, one every two seconds. */
const ROUND_TRIPS = 30;

/**
 * Takes pictures of a source, one at a time, while they are wanted. The next one is taken after the previous one was
 * sent: no picture waits in a queue, and the newest is sent.
 */
export function usePictures(options: {
  readonly source: () => PictureSource | undefined;
  readonly isWanted: () => boolean;
  /** Highest settings to use. */
  readonly settings: Readonly<PictureSettings>;
  readonly habits: () => Readonly<PictureHabits>;
  /** Results of modules for the pictures, per second. */
  readonly resultHz?: () => number | undefined;
  readonly publish: (image: Image2D, taken: TakenPicture) => void;
  /** Ends the topic, so that no picture stays on the master. [TD-48] */
  readonly end: () => void;
}) {
  const { client, isConnected } = useConnection();
  const measures = shallowReactive<PictureMeasures>({ ...NOTHING });
  const sent = new PictureMeter();
  const roundTripsMs: number[] = [];
  let state = FIRST_STATE;
  let calmFromMs = 0;
  let decidedMs = 0;
  onScopeDispose(
    client.onRoundTrip(({ lastMs }) => {
      roundTripsMs.push(lastMs);
      if (roundTripsMs.length > ROUND_TRIPS) roundTripsMs.shift();
    }),
  );

  function decide(): void {
    const { settings, habits, resultHz } = options;
    if (measures.sentAtMs === undefined || visibility.value === 'hidden') return;
    const nowMs = performance.now();
    const isLate = nowMs - decidedMs > LATE_MS;
    decidedMs = nowMs;
    // Browsers slow down background pages, even some that count as visible.
    if (isLate) forget();
    if (nowMs < calmFromMs) return;
    const before = adaptedStep(state, settings);
    state = habits().isAdaptive
      ? adaptPictures(state, settings, {
          nowMs: performance.now(),
          sent: sent.summary(),
          roundTripsMs,
          resultHz: resultHz?.(),
        })
      : FIRST_STATE;
    const after = adaptedStep(state, settings);
    if (after.width !== before.width || after.quality !== before.quality) sent.clear();
    measures.adapted = adaptationWords(state, settings, sent.summary());
  }
  const { pause, resume } = useIntervalFn(decide, DECIDE_MS, { immediate: false });
  watch(
    () => [{ ...options.settings }, options.habits().isAdaptive],
    () => {
      sent.clear();
      decide();
    },
  );

  // Measurements while disconnected or in the background say nothing about network and modules.
  const visibility = useDocumentVisibility();
  function forget(): void {
    sent.clear();
    roundTripsMs.length = 0;
    calmFromMs = performance.now() + CALM_MS;
  }
  watch([isConnected, visibility], ([connected], [wasConnected]) => {
    if (connected !== wasConnected) state = FIRST_STATE;
    forget();
  });

  watch(
    () => options.habits().keepsNewest,
    (keeps) => {
      // The kept picture is no longer wanted.
      if (!keeps && !options.isWanted()) options.end();
    },
  );

  watch(
    options.isWanted,
    (isWanted, _before, onCleanup) => {
      if (!isWanted) return;
      const encoder = new PictureEncoder();
      const meter = new RateMeter(undefined, SHOWN_WINDOW_MS);
      let isOver = false;
      let cancel: (() => void) | undefined;
      decidedMs = performance.now();
      resume();

      async function takeOne(): Promise<void> {
        const beginMs = performance.now();
        const source = options.source();
        const step = adaptedStep(state, options.settings);
        let { rateHz } = step;
        if (source) {
          const image = await encoder.encode(source, { ...options.settings, ...step });
          if (isOver) return;
          const encodedMs = performance.now();
          const takenMs = source.takenMs ?? beginMs;
          options.publish(image, {
            captureMs: source.takenMs === undefined ? undefined : beginMs - takenMs,
            encodeMs: encodedMs - beginMs,
            ageMs: encodedMs - takenMs,
            expiryMs: options.habits().keepsNewest ? 0 : pictureExpiryMs(rateHz),
          });
          rateHz = affordableRate(rateHz, image.data.length);
          note(image, encodedMs - beginMs, rateHz < step.rateHz);
          const leaveMs = await left(image.data.length);
          if (isOver) return;
          measures.leaveMs = leaveMs;
          sent.note({
            atMs: encodedMs,
            bytes: image.data.length,
            encodeMs: encodedMs - beginMs,
            leaveMs,
          });
        }
        const passedMs = performance.now() - beginMs;
        cancel = pictureClock.after(Math.max(0, 1000 / rateHz - passedMs), run);
      }

      /** @returns time until the picture was sent, milliseconds */
      async function left(bytes: number): Promise<number> {
        const beginMs = performance.now();
        let lookedMs = beginMs;
        while (!isOver && client.bufferedBytes > bytes * LEFT_SHARE) {
          lookedMs = performance.now();
          await new Promise<void>((resolve) => pictureClock.after(LEAVE_POLL_MS, resolve));
        }
        // On a busy page this check is late: the picture was sent soon after the previous check.
        return Math.min(performance.now(), lookedMs + LEAVE_POLL_MS) - beginMs;
      }

      function note(image: Image2D, encodeMs: number, isSlowed: boolean): void {
        const nowMs = performance.now();
        meter.note(nowMs);
        Object.assign(measures, {
          width: image.width,
          height: image.height,
          bytes: image.data.length,
          encodeMs,
          rateHz: meter.rateHz(nowMs),
          isSlowed,
          sentAtMs: nowMs,
        });
      }

      function run(): void {
        // Skip a picture that could not be encoded; the next one is taken at its time.
        takeOne().catch(() => {
          if (!isOver) cancel = pictureClock.after(1000 / options.settings.rateHz, run);
        });
      }
      run();
      onCleanup(() => {
        isOver = true;
        pause();
        cancel?.();
        encoder.close();
        sent.clear();
        Object.assign(measures, NOTHING);
        if (!options.habits().keepsNewest) options.end();
      });
    },
    { flush: 'post' },
  );
  return measures;
}
