import type { Image2D } from '@ubii/proto';
import { computed, watch, type ComputedRef, type Ref } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import type { PictureSettings } from '../../devices/camera/encode-picture.ts';
import { usePictureHabits } from '../../devices/camera/picture-habits.ts';
import { usePictures, type TakenPicture } from '../../devices/camera/usePictures.ts';
import { HeldPictures } from './held-pictures.ts';
import { useCameraRelease } from './useCameraRelease.ts';
import type { PictureSources } from './usePictureSource.ts';

/** Rate for image files, which change only when another one is chosen, Hz. */
const PHOTO_HZ = 2;

/** A picture with the timestamp of its results, master's clock. */
export type SentPicture = TakenPicture & { readonly takenMs: number };

/** Sends the pictures of a page's source while the example runs, unless the source is a topic. */
export function useSentPictures(options: {
  readonly sources: PictureSources;
  readonly isOn: Ref<boolean>;
  /** Highest settings; the rate depends on the kind of source. */
  readonly settings: PictureSettings;
  readonly isRegistered: Readonly<Ref<boolean>>;
  /** Topic of the page's own pictures. */
  readonly ownTopic: () => string | undefined;
  /** Results of modules per second; used for sources that change. */
  readonly resultHz?: () => number | undefined;
  readonly publish: (image: Image2D, taken: SentPicture) => void;
  readonly end: () => void;
}): {
  /** True when the pictures are those of this page. */
  readonly isOwn: ComputedRef<boolean>;
  /** Topic that modules read; `undefined` while there is none. */
  readonly image: ComputedRef<string | undefined>;
  readonly habits: ReturnType<typeof usePictureHabits>;
  readonly measures: ReturnType<typeof usePictures>;
  /** Recently sent pictures. */
  readonly held: HeldPictures;
} {
  const { sources, isOn, settings, isRegistered, ownTopic, resultHz, publish, end } = options;
  const { client, isConnected } = useConnection();
  const held = new HeldPictures();
  const habits = usePictureHabits();
  const wantedHz = settings.rateHz;

  const isOwn = computed(() => sources.kind.value !== 'topic');
  const image = computed(() => {
    if (!isRegistered.value) return undefined;
    return isOwn.value ? ownTopic() : sources.topic.value || undefined;
  });
  const isWanted = (): boolean =>
    isOn.value &&
    isOwn.value &&
    isConnected.value &&
    isRegistered.value &&
    sources.element.value !== undefined;
  watch(isWanted, (wanted) => (sources.isSent.value = wanted));
  const measures = usePictures({
    source: () => sources.source(),
    isWanted,
    settings,
    habits: () => habits.value,
    // Every sent photograph is analysed.
    resultHz: () => (sources.kind.value === 'photo' ? undefined : resultHz?.()),
    publish(picture, taken) {
      const takenMs = client.masterTime.nowMs() - taken.ageMs;
      held.add(takenMs, picture);
      publish(picture, { ...taken, takenMs });
    },
    end() {
      held.clear();
      end();
    },
  });
  useCameraRelease(sources, isOn);
  watch(sources.kind, (kind) => (settings.rateHz = kind === 'photo' ? PHOTO_HZ : wantedHz));
  return { isOwn, image, habits, measures, held };
}
