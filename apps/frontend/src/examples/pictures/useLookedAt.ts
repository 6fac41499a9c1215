import type { Image2D, TopicRecord } from '@ubii/proto';
import { useRafFn } from '@vueuse/core';
import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import type { HeldPictures } from './held-pictures.ts';
import { opacityAt, ResultLag } from './result-lag.ts';
import type { PictureSources } from './usePictureSource.ts';

/** Displayed picture, such that it matches the results. */
export interface LookedAt {
  /**
   * Picture of the newest result, shown instead of a newer one; undefined while results are current, or when it is not
   * held.
   */
  readonly picture: ComputedRef<Image2D | undefined>;
  /** Age of results, milliseconds; undefined while they are current. */
  readonly behindMs: Readonly<ShallowRef<number | undefined>>;
  /** Opacities of results that are older than the picture, 0 to 1, by topic. */
  readonly opacities: Readonly<ShallowRef<ReadonlyMap<string, number>>>;
}

/** Rounding of the displayed age, milliseconds. */
const AGE_STEP_MS = 100;

/**
 * Compares results with the displayed picture. Late results are shown with the picture that was analysed, if it is
 * held; otherwise they fade.
 *
 * @param records newest results, with the timestamps of their pictures
 */
export function useLookedAt(
  { kind }: Pick<PictureSources, 'kind'>,
  records: () => readonly TopicRecord[],
  held: HeldPictures,
): LookedAt {
  const { client, isConnected } = useConnection();
  const lag = new ResultLag();
  const isBehind = shallowRef(false);
  const behindMs = shallowRef<number>();
  const opacities = shallowRef<ReadonlyMap<string, number>>(new Map());
  /** Files do not change; the pictures of topics have other clients' clocks. */
  const isMoving = computed(() => kind.value === 'clip' || kind.value === 'camera');
  const newestMs = computed(() => {
    const times = isMoving.value ? records().flatMap(({ timestampMs }) => timestampMs ?? []) : [];
    return times.length > 0 ? Math.max(...times) : undefined;
  });
  const picture = computed(() =>
    isBehind.value && newestMs.value !== undefined ? held.at(newestMs.value) : undefined,
  );

  function opacitiesAt(pictureMs: number): ReadonlyMap<string, number> {
    const faded = records().map(
      ({ topic, timestampMs = pictureMs }) => [topic, opacityAt(pictureMs - timestampMs)] as const,
    );
    return new Map(faded.filter(([, opacity]) => opacity < 1));
  }
  useRafFn(() => {
    // Without the master, results are marked as old.
    if (!isConnected.value) return;
    const nowMs = client.masterTime.nowMs();
    lag.note(newestMs.value, nowMs);
    isBehind.value = lag.isBehind;
    behindMs.value = lag.isBehind
      ? Math.round(lag.medianMs / AGE_STEP_MS) * AGE_STEP_MS
      : undefined;
    const pictureMs = picture.value ? newestMs.value! : nowMs;
    const next = isMoving.value ? opacitiesAt(pictureMs) : new Map<string, number>();
    if (!isSame(opacities.value, next)) opacities.value = next;
  });
  return { picture, behindMs, opacities };
}

const isSame = (a: ReadonlyMap<string, number>, b: ReadonlyMap<string, number>): boolean =>
  a.size === b.size && [...a].every(([topic, opacity]) => b.get(topic) === opacity);
