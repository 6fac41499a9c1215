import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import type { IdentityStorage, UbiiClient } from '@ubii/client-web/node';
import { ConfigError } from '@ubii/program';
import { DEFAULT_TEXT_LIMITS } from '@ubii/proto';
import { keepToOwner, OWNER_FOLDER_MODE, recordingPath } from '@ubii/recording/node';
import { recordOnThread } from '@ubii/recording/thread';
import { systemClock } from '@ubii/timing/system';
import type { Log } from '@ubii/client-program';
import { keptFile } from './kept-file.ts';
import { NodeRecorder } from './node-recorder.ts';
import { sendFile } from './send-file.ts';

/** As on the master. [RC-19] [RC-23] [RC-44] */
const LIMITS = {
  markersPerRecording: 10_000,
  recordingCheckMs: 20_000,
  recordingCheckBytes: 640 * 1024 * 1024,
  recorderQueueBytes: 32 * 1024 * 1024,
};

/** What a recorder of a node is opened with. */
export interface RecorderSetup {
  readonly client: UbiiClient;
  /** URL of the master that the program was started with. */
  readonly master: string;
  /** URL of the master that the client is at now. */
  readonly masterUrl: () => string;
  /** Folder for recordings of all masters. */
  readonly folder: string;
  /** Most space of all recordings of this master, bytes. */
  readonly maxBytes: number;
  /** Shows who this client is, of this moment. */
  readonly credential: () => string | undefined;
  readonly log: Log;
  /** The built thread that records. */
  readonly workerFile: URL;
  /** The built process that checks the files of earlier runs. [RC-44] */
  readonly checkProcessFile: URL;
}

/** Records into a folder of this machine. @throws ConfigError when it cannot be used */
export async function openRecorder(setup: RecorderSetup): Promise<NodeRecorder> {
  const { client, master, masterUrl, log, credential, maxBytes } = setup;
  const { workerFile, checkProcessFile } = setup;
  // What was recorded at one master is not given to another one.
  const folder = join(setup.folder, encodeURIComponent(new URL(master).host));
  try {
    await mkdir(folder, { recursive: true, mode: OWNER_FOLDER_MODE });
    await keepToOwner(folder);
  } catch (error) {
    const { message } = error as Error;
    throw new ConfigError(`The folder ${setup.folder} (--record-dir) cannot be used: ${message}.`);
  }
  const recorder = recordOnThread({
    folder,
    workerFile,
    checkProcessFile,
    clock: systemClock,
    limits: { ...DEFAULT_TEXT_LIMITS, ...LIMITS, recordingsBytes: maxBytes },
    onFailure: (what, reason) => log('error', `${what}: ${reason}`),
  });
  return new NodeRecorder({
    client,
    recorder,
    log,
    async send(recordingId, signal, onProgress) {
      await keptFile(recorder, recordingId, systemClock, signal);
      return sendFile({
        recordingId,
        master: masterUrl(),
        signal,
        onProgress,
        path: recordingPath(folder, recordingId),
        clientId: client.id ?? '',
        credential: credential(),
      });
    },
  });
}

/** A storage of an identity that shows the credential in it. */
export function watchCredential(storage: IdentityStorage): {
  readonly identity: IdentityStorage;
  credential(): string | undefined;
} {
  let credential: string | undefined;
  return {
    credential: () => credential,
    identity: {
      ...storage,
      async load() {
        const identity = await storage.load();
        credential = identity?.credential;
        return identity;
      },
      save(identity) {
        credential = identity?.credential;
        storage.save(identity);
      },
    },
  };
}
