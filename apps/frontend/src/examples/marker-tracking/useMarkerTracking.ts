import { DEFAULT_DICTIONARY } from '@ubii/vision/markers';
import { useIntervalFn, useRafFn } from '@vueuse/core';
import { computed, reactive, shallowRef, watch } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { useCalibrations } from '../../devices/camera/calibration-memory.ts';
import type { PictureSettings } from '../../devices/camera/encode-picture.ts';
import { RateMeter } from '../../devices/sensors/rate-meter.ts';
import { useDevice } from '../../devices/useDevice.ts';
import type { ModulePlace } from '../../sessions/own/planned-session.ts';
import { useOwnedSession } from '../../sessions/own/useOwnedSession.ts';
import type { PictureSources } from '../pictures/usePictureSource.ts';
import { useIsOn } from '../pictures/useIsOn.ts';
import { useKeptPlace } from '../pictures/useKeptChoice.ts';
import { useLookedAt } from '../pictures/useLookedAt.ts';
import { useSentPictures } from '../pictures/useSentPictures.ts';
import { CLIP_MARKER_METRES } from '../pictures/clips/marker-clip.ts';
import { MarkerReadings, type MarkerReading } from './marker-readings.ts';
import { TRACKING_COMPONENTS, TRACKING_DEVICE, trackingSession } from './tracking-session.ts';

/** Time after which results are outdated, milliseconds; in background tabs and on slow nodes they are rare. */
const SLOW_MS = 5000;
const FIGURES_MS = 1000;
const RATE_HZ = 20;

/** Tracks markers in the pictures of a source with a session of this page. */
export function useMarkerTracking(sources: PictureSources) {
  const { isConnected, name } = useConnection();
  const { isOn, wasEnded } = useIsOn(sources);
  const place = useKeptPlace();
  const options = reactive({
    dictionary: DEFAULT_DICTIONARY,
    sizeMm: String(CLIP_MARKER_METRES * 1000),
    smoothingMs: 0,
  });
  /** Corners need more pixels than objects: the width is larger than in other examples. */
  const settings = reactive<PictureSettings>({
    width: 1280,
    rateHz: RATE_HZ,
    encoding: 'JPEG',
    quality: 0.9,
  });

  /** The labels on the picture and the list show the same reading. */
  const reading = shallowRef<MarkerReading>();
  const error = shallowRef('');
  const figures = shallowRef<{
    readonly seenHz?: number | undefined;
    readonly ms?: number | undefined;
    readonly decodeMs?: number | undefined;
  }>({});
  const placeMs = shallowRef<
    ReadonlyMap<ModulePlace, { readonly ms: number; readonly hint: string }>
  >(new Map());
  const seen = new RateMeter(SLOW_MS);
  const readings = new MarkerReadings();
  let newest: MarkerReading | undefined;
  let newestAtMs = -Infinity;
  let durationMs: number | undefined;
  let decodeMs: number | undefined;

  function take(next: MarkerReading | undefined): void {
    if (next === undefined) return;
    newest = next;
    newestAtMs = performance.now();
    seen.note(newestAtMs);
  }

  const device = useDevice({
    name: TRACKING_DEVICE,
    tags: ['example', 'camera'],
    components: TRACKING_COMPONENTS,
    receivers: {
      markers: ({ elements: markers }, { timestampMs }) =>
        take(readings.take(timestampMs, { markers })),
      outlines: (_value, outlines) => take(readings.take(outlines.timestampMs, { outlines })),
      decode: (value) => (decodeMs = value),
      duration: (value) => (durationMs = value),
      error: (value) => (error.value = value),
    },
  });
  const { isOwn, image, habits, measures, held } = useSentPictures({
    sources,
    isOn,
    settings,
    isRegistered: device.isRegistered,
    ownTopic: () => device.topicOf('image'),
    resultHz: () => seen.rateHz(performance.now()),
    publish: (picture, { takenMs: timestampMs, expiryMs }) =>
      device.publish('image', picture, { timestampMs, immediate: true, expiryMs }),
    end: () => device.end('image'),
  });

  const calibrations = useCalibrations();
  /** Calibration of the source camera, if this browser has one. */
  const calibration = computed(() =>
    sources.kind.value === 'camera' ? (calibrations.of(sources.camera.chosen.value) ?? '') : '',
  );
  const sizeMetres = computed(() => Number(options.sizeMm) / 1000);
  const session = useOwnedSession({
    life: 'page',
    spec: () => {
      if (!isOn.value || image.value === undefined || !(sizeMetres.value > 0)) return undefined;
      return {
        place: place.value,
        session: trackingSession({
          owner: name.value,
          image: image.value,
          outputs: {
            markers: device.topicOf('markers')!,
            outlines: device.topicOf('outlines')!,
            decodeMs: device.topicOf('decode')!,
            durationMs: device.topicOf('duration')!,
            error: device.topicOf('error')!,
          },
          dictionary: options.dictionary,
          sizeMetres: sizeMetres.value,
          smoothingMs: options.smoothingMs,
          calibration: calibration.value,
        }),
      };
    },
    onFailure: () => (isOn.value = false),
  });

  function clear(): void {
    newest = undefined;
    readings.clear();
    durationMs = undefined;
    decodeMs = undefined;
    error.value = '';
    seen.clear();
    figures.value = {};
  }
  watch([place, () => sources.kind.value, isOn, () => options.dictionary], clear);

  useRafFn(() => {
    // Without the master, the last results stay, marked as old.
    if (!isConnected.value) return;
    if (performance.now() - newestAtMs > SLOW_MS) newest = undefined;
    reading.value = newest;
  });
  const lookedAt = useLookedAt(
    sources,
    () => (reading.value ? [reading.value.outlines] : []),
    held,
  );
  useIntervalFn(() => {
    if (!isConnected.value) {
      figures.value = {};
      return;
    }
    const seenHz = seen.rateHz(performance.now());
    figures.value = { seenHz, ms: durationMs, decodeMs };
    if (durationMs !== undefined && seenHz !== undefined) {
      placeMs.value = new Map(placeMs.value).set(place.value, { ms: durationMs, hint: '' });
    }
  }, FIGURES_MS);

  return {
    isOn,
    wasEnded,
    place,
    options,
    sizeMetres,
    calibration,
    image,
    isOwn,
    habits,
    settings,
    measures,
    topicOf: device.topicOf,
    reading,
    lookedAt,
    error,
    figures,
    placeMs,
    ...session,
  };
}
