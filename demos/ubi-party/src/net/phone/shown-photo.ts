import type { Clock, UbiiClient } from '@ubii/client-web';
import { Image2DDataFormat } from '@ubii/proto';

import { phoneTopic, isHidden, photoId, type HiddenPhotos, type Photo } from '../protocol.ts';

/** A photo is repeated so often while it is shown, and is gone when it was not for three times as long. */
const AGAIN_MS = 5000;

/** The photo that a phone shows on the big screen: one at a time, gone from the master when it ends. */
export class ShownPhoto {
  readonly #client: UbiiClient;
  readonly #clock: Clock;
  #photo: Photo | undefined;
  #hidden: HiddenPhotos | undefined;
  #stop: (() => void) | undefined;

  constructor(client: UbiiClient, clock: Clock) {
    this.#client = client;
    this.#clock = clock;
  }

  /** @param photo undefined: none any more */
  show(photo: Photo | undefined): void {
    if (photo && isHidden(this.#hidden, photoId(this.#client.id, photo))) return this.#end();
    if (!photo) return this.#end();
    this.#photo = photo;
    this.#publish();
    this.#stop ??= this.#clock.every(AGAIN_MS, () => this.#publish());
  }

  /** Applies the host's list of removed photos: they are hidden for everybody. */
  setHidden(hidden: HiddenPhotos | undefined): void {
    this.#hidden = hidden;
    if (this.#photo && isHidden(hidden, photoId(this.#client.id, this.#photo))) this.#end();
  }

  #publish(): void {
    const { jpeg: data, width, height, atMs } = this.#photo!;
    const image = { width, height, dataFormat: Image2DDataFormat.RGB8, data };
    this.#client.publish(phoneTopic(this.#client.id, 'photo'), 'image2D', image, {
      timestampMs: atMs,
      expiryMs: 3 * AGAIN_MS,
    });
  }

  #end(): void {
    if (!this.#photo) return;
    this.#photo = undefined;
    this.#stop?.();
    this.#stop = undefined;
    this.#client.endTopic(phoneTopic(this.#client.id, 'photo'));
  }
}
