import { useIntervalFn } from '@vueuse/core';
import { computed, shallowRef, watch, type ComputedRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import type { PictureSources } from '../pictures/usePictureSource.ts';

/** Rate of pictures at a step of the processing. */
export interface FunnelRate {
  readonly name: string;
  /** `undefined` while nothing is measured. */
  readonly hz: number | undefined;
  readonly unit: string;
  readonly kind: 'picture' | 'result' | 'replaced';
  /** True when the rate is too high. */
  readonly isMuch: boolean;
  /** Recent rates, oldest first. */
  readonly history: readonly (number | undefined)[];
}

/** Interval between samples, milliseconds; the history covers twenty seconds. */
const SAMPLE_MS = 500;
const SAMPLES = 40;
/** Share of replaced pictures from which a warning is shown. */
const MANY_REPLACED = 0.15;
const GIVERS = {
  clip: 'From the clip',
  camera: 'From the camera',
  photo: 'File',
  topic: 'From the topic',
};

/** Rates of pictures from the source to the results: captured, sent, analysed, replaced. */
export function useRateFunnel(
  sources: PictureSources,
  detection: {
    readonly isOn: Readonly<{ value: boolean }>;
    readonly isOwn: Readonly<{ value: boolean }>;
    readonly rates: Readonly<{
      value: { readonly sentHz?: number | undefined; readonly seenHz?: number | undefined };
    }>;
  },
): ComputedRef<readonly FunnelRate[]> {
  const { topics } = useConnection();
  const givenHz = shallowRef<number>();
  const history = shallowRef<readonly (readonly (number | undefined)[])[]>([]);

  const now = computed(() => {
    const { sentHz, seenHz } = detection.rates.value;
    const passedHz = detection.isOwn.value ? sentHz : givenHz.value;
    const isKnown = passedHz !== undefined && seenHz !== undefined;
    const replacedHz = isKnown ? Math.max(0, passedHz - seenHz) : undefined;
    return { givenHz: givenHz.value, sentHz: passedHz, seenHz, replacedHz };
  });
  useIntervalFn(() => {
    const followed = topics.rates.value?.get(sources.topic.value);
    givenHz.value = detection.isOwn.value ? sources.givenHz() : followed?.hz;
    if (!detection.isOn.value) return;
    const sample = Object.values(now.value);
    history.value = [...history.value, sample].slice(-SAMPLES);
  }, SAMPLE_MS);
  watch([detection.isOn, sources.kind], () => (history.value = []));

  return computed(() => {
    const { givenHz: given, sentHz, seenHz, replacedHz } = now.value;
    const isMuch = replacedHz !== undefined && replacedHz > MANY_REPLACED * (sentHz ?? 0);
    const line = (at: number) => history.value.map((sample) => sample[at]);
    const plain = { unit: 'fps', isMuch: false } as const;
    return [
      {
        ...plain,
        name: GIVERS[sources.kind.value],
        hz: given,
        kind: 'picture',
        history: line(0),
      },
      { ...plain, name: 'Sent to the module', hz: sentHz, kind: 'picture', history: line(1) },
      { ...plain, name: 'Processed', hz: seenHz, kind: 'result', history: line(2) },
      {
        name: 'Replaced by a newer one',
        hz: replacedHz,
        unit: '/s',
        isMuch,
        kind: 'replaced',
        history: line(3),
      },
    ];
  });
}
