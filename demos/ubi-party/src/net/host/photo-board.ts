import { readPictureFile, type PictureFile } from '@ubii/pictures';
import type { UbiiClient } from '@ubii/client-web';
import { decodeRecord } from '@ubii/proto';

import {
  MAX_PHOTO_BYTES,
  MAX_PHOTO_SIDE,
  PHONE_DEVICE,
  phoneOf,
  isHidden,
  photoId,
  type HiddenPhotos,
  type Photo,
} from '../protocol.ts';

/**
 * Returns a JPEG file that the big screen may decode: small in bytes, and in pixels, of which a small file may state many
 * [EX-98]. Undefined for other data.
 */
export function photoFile(data: Uint8Array): PictureFile | undefined {
  if (data.length > MAX_PHOTO_BYTES) return undefined;
  try {
    const file = readPictureFile(data);
    const isSmall = Math.max(file.width, file.height) <= MAX_PHOTO_SIDE;
    return file.format === 'JPEG' && isSmall ? file : undefined;
  } catch {
    return undefined;
  }
}

/** Photos that were taken down are remembered, the newest so many. */
const MAX_HIDDEN = 64;

interface PhotoBoardOptions {
  readonly client: UbiiClient;
  /** Whether a client has a seat. */
  readonly isPlayer: (clientId: string) => boolean;
  /** Photos came, went, or were taken down. */
  readonly handleChange: () => void;
}

/** The photos that players show on the big screen, and which of them the host has taken down. */
export class PhotoBoard {
  readonly #options: PhotoBoardOptions;
  readonly #photos = new Map<string, Photo>();
  #hidden: HiddenPhotos;
  #stop: (() => void) | undefined;

  constructor(options: PhotoBoardOptions, areAllHidden: boolean) {
    this.#options = options;
    this.#hidden = { all: areAllHidden, ids: [] };
  }

  /** By client id. */
  get photos(): ReadonlyMap<string, Photo> {
    return this.#photos;
  }

  get hidden(): HiddenPhotos {
    return this.#hidden;
  }

  open(): void {
    const glob = `/*/${PHONE_DEVICE}/photo`;
    this.#stop ??= this.#options.client.subscribeEncoded(
      { glob },
      {
        onRecord: ({ topic, bytes }) => this.#handleRecord(topic, bytes),
        onGone: (topic) => this.#remove(phoneOf(topic, 'photo')),
      },
    );
  }

  close(): void {
    this.#stop?.();
    this.#stop = undefined;
    if (this.#photos.size === 0) return;
    this.#photos.clear();
    this.#options.handleChange();
  }

  /** Takes the photo of a client down for everybody. */
  takeDown(clientId: string): void {
    const photo = this.#photos.get(clientId);
    if (!photo) return;
    const ids = [...this.#hidden.ids, photoId(clientId, photo)].slice(-MAX_HIDDEN);
    this.#hidden = { ...this.#hidden, ids };
    this.#remove(clientId);
  }

  /** Hides all photos, also those to come; or shows those to come again. */
  hideAll(all: boolean): void {
    this.#hidden = { ...this.#hidden, all };
    if (all) this.#photos.clear();
    this.#options.handleChange();
  }

  #handleRecord(topic: string, bytes: Uint8Array): void {
    const clientId = phoneOf(topic, 'photo');
    if (clientId === undefined || !this.#options.isPlayer(clientId)) return;
    const photo = readPhoto(bytes);
    if (!photo || isHidden(this.#hidden, photoId(clientId, photo))) return this.#remove(clientId);
    if (this.#photos.get(clientId)?.atMs === photo.atMs) return;
    this.#photos.set(clientId, photo);
    this.#options.handleChange();
  }

  #remove(clientId: string | undefined): void {
    if (clientId !== undefined && this.#photos.delete(clientId)) this.#options.handleChange();
  }
}

function readPhoto(bytes: Uint8Array): Photo | undefined {
  const record = decodeRecord(bytes);
  if (record.format !== 'image2D' || record.timestampMs === undefined) return undefined;
  const file = photoFile(record.value.data);
  if (!file) return undefined;
  // The size of the record may differ from that of the file.
  const { width, height } = file;
  return { jpeg: new Uint8Array(file.data), width, height, atMs: Math.round(record.timestampMs) };
}
