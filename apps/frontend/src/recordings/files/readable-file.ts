import type { UbiiClient } from '@ubii/client-web';
import { atMaster } from '../../connection/at-master.ts';
import { recordingFileUrl } from '../../locations/recording-location.ts';

/** The file of a recording of the master. A worker can receive it. */
export interface MasterFile {
  readonly url: string;
  /** Value of the header `Authorization`; undefined for clients without an invitation. [AC-13] */
  readonly authorization: string | undefined;
}

/** A recording that can be read: of this device, or of the master. */
export type ReadableFile = Blob | MasterFile;

/** @param id of the recording */
export const masterFile = (
  id: string,
  client: Pick<UbiiClient, 'authorization'> & Partial<Pick<UbiiClient, 'masterUrl'>>,
): MasterFile => ({
  url: atMaster(client, recordingFileUrl(id)),
  authorization: client.authorization,
});

/** Requests a file of the master, or a part of it, as the client that this page is. */
export function fetchFile(file: MasterFile, init: RequestInit = {}): Promise<Response> {
  return fetch(file.url, { ...init, headers: authorized(file.authorization, init.headers) });
}

/** Headers with what shows who sends the request. */
export function authorized(authorization: string | undefined, headers?: HeadersInit): Headers {
  const all = new Headers(headers);
  if (authorization !== undefined) all.set('Authorization', authorization);
  return all;
}
