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

/** What was measured of the last pictures; all `undefined` while none are sent. */
export interface PictureMeasures {
  width: number | undefined;
  height: number | undefined;
  bytes: number | undefined;
  /** Drawing, scaling and packing one picture, milliseconds. */
  encodeMs: number | undefined;
  /** Until the system had taken it, milliseconds. */
  leaveMs: number | undefined;
  rateHz: number | undefined;
  /** Fewer than wanted, to keep within the bound on bytes. */
  isSlowed: boolean;
  /** What is sent otherwise than wanted, and why, one sentence. */
  adapted: string | undefined;
  /** When the last one left, on the clock of `performance.now()`. */
  sentAtMs: number | undefined;
}

/** How a picture was made, and how it is to be published. */
export interface TakenPicture {
  /** From the light on the camera to the encoder; `undefined` where the browser does not tell. Milliseconds. */
  readonly captureMs: number | undefined;
  readonly encodeMs: number;
  /** Since the picture was taken, milliseconds. */
  readonly ageMs: number;
  /** How long it stands on the master without a newer one; 0: as long as the client is there. [TD-49] */
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

/** How often settings are decided on, milliseconds. */
const DECIDE_MS = 500;
/** After a time without a master, or behind another page, figures are those of before for so long, milliseconds. */
const CALM_MS = 4000;
/** A decision that comes so long after the one before was held up, milliseconds. */
const LATE_MS = 1.8 * DECIDE_MS;
/** How often is looked whether a picture has left: WebSocket has no event for it, milliseconds. */
const LEAVE_POLL_MS = 4;
/** A picture has left when no more than this share of it is here. */
const LEFT_SHARE = 0.1;
/** Round trips remembered for the shortest, two seconds each. */
const ROUND_TRIPS = 30;

/**
 * Takes pictures of a source, one at a time, while they are wanted. The next one is taken when the one before has left:
 * none waits anywhere on the way to the link, and what is sent is always the newest.
 */
export function usePictures(options: {
  readonly source: () => PictureSource | undefined;
  readonly isWanted: () => boolean;
  /** What is wanted at most. */
  readonly settings: Readonly<PictureSettings>;
  readonly habits: () => Readonly<PictureHabits>;
  /** Results that modules give for the pictures, per second. */
  readonly resultHz?: () => number | undefined;
  readonly publish: (image: Image2D, taken: TakenPicture) => void;
  /** Nothing of the pictures is to stay on the master. [TD-48] */
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
    // Browsers slow down pages behind others, also such as count as visible.
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

  // A time without a master, or behind another page, is not the measure of a link, nor of a module.
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
      // What was kept is not to be there any longer.
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

      /** @returns how long the picture took to leave, milliseconds */
      async function left(bytes: number): Promise<number> {
        const beginMs = performance.now();
        let lookedMs = beginMs;
        while (!isOver && client.bufferedBytes > bytes * LEFT_SHARE) {
          lookedMs = performance.now();
          await new Promise<void>((resolve) => pictureClock.after(LEAVE_POLL_MS, resolve));
        }
        // It left soon after the last look, however late a busy page looks again.
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
        // One that could not be made is let go of; the next is tried at its time.
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
