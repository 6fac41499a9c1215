import type { Image2D } from '@ubii/proto';
import { computed, watch, type ComputedRef, type Ref } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import type { PictureSettings } from '../../devices/camera/encode-picture.ts';
import { usePictureHabits } from '../../devices/camera/picture-habits.ts';
import { usePictures, type TakenPicture } from '../../devices/camera/usePictures.ts';
import { HeldPictures } from './held-pictures.ts';
import { useCameraRelease } from './useCameraRelease.ts';
import type { PictureSources } from './usePictureSource.ts';

/** An image file changes when another one is chosen. */
const PHOTO_HZ = 2;

/** A picture with the timestamp that its results will have, master's clock. */
export type SentPicture = TakenPicture & { readonly takenMs: number };

/** Sends the pictures of a page's source while the example runs, unless a topic is the source. */
export function useSentPictures(options: {
  readonly sources: PictureSources;
  readonly isOn: Ref<boolean>;
  /** What is wanted at most; the rate follows the kind of source. */
  readonly settings: PictureSettings;
  readonly isRegistered: Readonly<Ref<boolean>>;
  /** Topic of the page's own pictures. */
  readonly ownTopic: () => string | undefined;
  /** Results of modules per second; counts for sources that change. */
  readonly resultHz?: () => number | undefined;
  readonly publish: (image: Image2D, taken: SentPicture) => void;
  readonly end: () => void;
}): {
  /** The pictures are those of this page. */
  readonly isOwn: ComputedRef<boolean>;
  /** Topic of the pictures that modules take; `undefined` while there is none. */
  readonly image: ComputedRef<string | undefined>;
  readonly habits: ReturnType<typeof usePictureHabits>;
  readonly measures: ReturnType<typeof usePictures>;
  /** The last ones. */
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
    // A photograph is looked at as often as it is sent.
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
