import type { TopicRecord } from '@ubii/proto';
import { useDocumentVisibility, useIntervalFn, useRafFn } from '@vueuse/core';
import { reactive, shallowRef, watch } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import type { PictureSettings } from '../../devices/camera/encode-picture.ts';
import { seeingSession, type Seen } from '../../devices/camera/seeing-session.ts';
import type { TakenPicture } from '../../devices/camera/usePictures.ts';
import { RateMeter, SHOWN_WINDOW_MS } from '../../devices/sensors/rate-meter.ts';
import { useDevice } from '../../devices/useDevice.ts';
import type { ModulePlace } from '../../sessions/own/planned-session.ts';
import { useOwnedSession } from '../../sessions/own/useOwnedSession.ts';
import { useIsOn } from '../pictures/useIsOn.ts';
import { useKeptChoice, useKeptPlace } from '../pictures/useKeptChoice.ts';
import { useLookedAt } from '../pictures/useLookedAt.ts';
import { useSentPictures } from '../pictures/useSentPictures.ts';
import { SEEING_COMPONENTS, SEEING_DEVICE } from './seeing-topics.ts';
import { useClockError } from './useClockError.ts';
import { useDetector } from './useDetector.ts';
import { StageTimes, type StageSummary } from './stage-times.ts';
import type { PictureSources } from '../pictures/usePictureSource.ts';

/** Time after which results are outdated, milliseconds. */
const HOLD_MS = 3000;
/** Interval between updates of figures, milliseconds. */
const FIGURES_MS = 1000;
const WANTED_HZ = 30;
const MAX_MODULE_HZ = 120;
/** Most pictures whose encoding time is kept until their result arrives. */
const MAX_UNDERWAY = 64;

/** Results for the newest picture, by kind of detection. */
export type Found = ReadonlyMap<Seen, TopicRecord>;

/** Analyses the pictures of a source with a session of this page. */
export function useObjectDetection(sources: PictureSources) {
  const { client, isConnected, name } = useConnection();
  const { isOn, wasEnded } = useIsOn(sources);
  const place = useKeptPlace();
  const detector = useDetector();
  const { threshold } = detector;
  const looksFor = useKeptChoice<Record<Seen, boolean>>('looks-for', {
    objects: true,
    bodies: false,
    hands: false,
  }).value;
  const settings = reactive<PictureSettings>({
    width: 640,
    rateHz: WANTED_HZ,
    encoding: 'JPEG',
    quality: 0.8,
  });

  const found = shallowRef<Found>(new Map());
  const belowThreshold = shallowRef<TopicRecord>();
  const backend = shallowRef('');
  const backendFault = shallowRef('');
  const stages = shallowRef<StageSummary>();
  const rates = shallowRef<{
    readonly sentHz?: number | undefined;
    readonly seenHz?: number | undefined;
  }>({});
  /** Median detection time of the nodes that were tried. */
  const placeMs = shallowRef<
    ReadonlyMap<ModulePlace, { readonly ms: number; readonly hint: string }>
  >(new Map());

  const newest = new Map<Seen, { readonly record: TopicRecord; readonly atMs: number }>();
  const times = new StageTimes();
  const results = new RateMeter(HOLD_MS);
  /** Measured like the rate of sent pictures, which is shown beside it. */
  const shown = new RateMeter(HOLD_MS, SHOWN_WINDOW_MS);
  const made = new Map<number, Pick<TakenPicture, 'captureMs' | 'encodeMs'>>();
  let decodeMs: number | undefined;
  let result: { readonly takenMs: number; readonly arrivedMs: number } | undefined;
  let hasChanged = false;

  /** Ignores retained records from an earlier time. */
  const isNew = ({ timestampMs }: TopicRecord): boolean =>
    timestampMs === undefined || times.counts(timestampMs);

  function take(what: Seen, record: TopicRecord): void {
    if (!isNew(record)) return;
    newest.set(what, { record, atMs: performance.now() });
    hasChanged = true;
    if (what !== 'objects') return;
    results.note(performance.now());
    shown.note(performance.now());
    const takenMs = record.timestampMs;
    result = takenMs === undefined ? undefined : { takenMs, arrivedMs: client.masterTime.nowMs() };
  }

  /** Arrives after the objects of the same picture. */
  function takeDuration(durationMs: number, finishedMs: number | undefined): void {
    const of = result;
    const decodedInMs = decodeMs;
    result = undefined;
    decodeMs = undefined;
    if (of === undefined || finishedMs === undefined) return;
    requestAnimationFrame(() =>
      times.add({
        ...of,
        ...(made.get(Math.round(of.takenMs)) ?? { encodeMs: 0 }),
        decodeMs: decodedInMs,
        finishedMs,
        durationMs,
        drawnMs: client.masterTime.nowMs(),
      }),
    );
  }

  /** Pictures of other clients may be old: retained ones are analysed, too. */
  const clearTimes = (): void => times.clear(isOwn.value ? client.masterTime.nowMs() : undefined);

  const device = useDevice({
    name: SEEING_DEVICE,
    tags: ['example', 'camera'],
    components: SEEING_COMPONENTS,
    receivers: {
      objects: (_value, record) => take('objects', record),
      belowThreshold(_value, record) {
        if (isNew(record)) belowThreshold.value = record;
      },
      bodies: (_value, record) => take('bodies', record),
      hands: (_value, record) => take('hands', record),
      decode: (value) => (decodeMs = value),
      duration: (value, { timestampMs }) => takeDuration(value, timestampMs),
      backend: (value) => (backend.value = value),
      error: (value) => (detector.problem.value = value),
      backendFault: (value) => (backendFault.value = value),
    },
  });
  detector.publishOn(device, isConnected);
  const clocks = useClockError(place, isOn);
  const { isOwn, image, habits, measures, held } = useSentPictures({
    sources,
    isOn,
    settings,
    isRegistered: device.isRegistered,
    ownTopic: () => device.topicOf('image'),
    // Only results for objects are counted.
    resultHz: () => (looksFor.objects ? results.rateHz(performance.now()) : undefined),
    publish(picture, { takenMs, captureMs, encodeMs, expiryMs }) {
      made.set(Math.round(takenMs), { captureMs, encodeMs });
      if (made.size > MAX_UNDERWAY) made.delete(made.keys().next().value!);
      device.publish('image', picture, { timestampMs: takenMs, immediate: true, expiryMs });
    },
    end: () => device.end('image'),
  });

  const session = useOwnedSession({
    life: 'page',
    spec: () => {
      if (!isOn.value || image.value === undefined) return undefined;
      const topicIf = (what: Seen) => (looksFor[what] ? device.topicOf(what) : undefined);
      return {
        place: place.value,
        session: seeingSession({
          name: `Object detection of ${name.value}`,
          description:
            'Detects objects in the pictures of the Object detection example. Ends when the page is closed.',
          tags: ['example', 'camera'],
          image: image.value,
          found: {
            objects: topicIf('objects'),
            bodies: topicIf('bodies'),
            hands: topicIf('hands'),
          },
          inputs: { threshold: device.topicOf('threshold'), detector: device.topicOf('detector') },
          // The rate is that of the pictures, which is adapted.
          constants: { maxRate: { double: MAX_MODULE_HZ } },
          outputs: {
            decodeMs: device.topicOf('decode'),
            durationMs: device.topicOf('duration'),
            backend: device.topicOf('backend'),
            error: device.topicOf('error'),
            belowThreshold: device.topicOf('belowThreshold'),
            backendFault: device.topicOf('backendFault'),
          },
        }),
      };
    },
    onFailure: () => (isOn.value = false),
  });

  // The module applies it to the next picture. A restarted master does not know it.
  watch(
    [threshold, device.isRegistered, isConnected],
    ([value, isKnown, connected]) => isKnown && connected && device.publish('threshold', value),
    { immediate: true },
  );
  watch([place, () => sources.kind.value, isOn], () => {
    clearTimes();
    results.clear();
    shown.clear();
    stages.value = undefined;
    backend.value = '';
    detector.problem.value = '';
    backendFault.value = '';
    belowThreshold.value = undefined;
    newest.clear();
    hasChanged = true;
  });

  // Time while disconnected, in the background, or before this page was opened is not latency.
  watch([isConnected, useDocumentVisibility()], clearTimes, { immediate: true });

  useRafFn(() => {
    // Without the master, the last results stay, marked as old.
    if (!isConnected.value) return;
    const nowMs = performance.now();
    for (const [what, { atMs }] of newest) {
      if (looksFor[what] && nowMs - atMs <= HOLD_MS) continue;
      newest.delete(what);
      hasChanged = true;
    }
    if (!hasChanged) return;
    hasChanged = false;
    found.value = new Map([...newest].map(([what, { record }]) => [what, record]));
  });
  const lookedAt = useLookedAt(sources, () => [...found.value.values()], held);
  useIntervalFn(() => {
    if (!isConnected.value) {
      rates.value = {};
      return;
    }
    const nowMs = performance.now();
    stages.value = times.summary(client.masterTime.nowMs(), clocks.errorMs());
    rates.value = { sentHz: measures.rateHz, seenHz: shown.rateHz(nowMs) };
    const detect = stages.value?.stages.find(({ name }) => name === 'Detect');
    if (detect && backend.value !== '') {
      placeMs.value = new Map(placeMs.value).set(place.value, {
        ms: detect.ms,
        hint: backend.value,
      });
    }
  }, FIGURES_MS);

  return {
    isOn,
    wasEnded,
    place,
    threshold,
    detector,
    looksFor,
    settings,
    habits,
    measures,
    image,
    found,
    lookedAt,
    belowThreshold,
    backend,
    backendFault,
    stages,
    rates,
    placeMs,
    isOwn,
    ...session,
  };
}
