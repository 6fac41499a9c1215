import { ServiceError, type Recording } from '@ubii/proto';
import type { Recorder, RecordingJob } from '@ubii/recording/recorder';
import type { Caller } from '../access/caller.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { NodeRecordings } from './node-recordings.ts';
import type { RecordingRoom } from './recording-room.ts';
import { UploadSpace, type HeldUpload } from './upload-space.ts';

/** A file that is uploaded. */
export interface Upload {
  /** Of the recording that it becomes. */
  readonly id: string;
  /** Size that it claims, bytes; 0 when it is unknown. */
  readonly declaredBytes: number;
  /** Stores it; calls `take` for each part before, which rejects when there is no space. Nothing is kept when it fails. */
  readonly receive: (take: (bytes: number) => Promise<void>) => Promise<void>;
  /** Whether its sender still waits for the reply. */
  readonly isAwaited: () => boolean;
}

/** The file of a recording that a node made. [RC-63] */
export interface NodeUpload extends Omit<Upload, 'id' | 'isAwaited'> {
  readonly recordingId: string;
  /** Id of the client that brings it, as it says. */
  readonly clientId: string;
}

/** What a recording of an upload is called, whose it is, and what it belongs to. */
export type UploadWish = Pick<
  RecordingJob,
  'name' | 'notes' | 'author' | 'makerId' | 'study' | 'replayedRecordingId' | 'keepsStudy'
>;

/** Who uploads, as `HeldUpload` counts it. */
export type UploadSender = Pick<HeldUpload, 'sender' | 'clientId'>;

/** @param place of the caller; callers without a client count together by it */
export function uploadSenderOf(caller: Caller, place: string): UploadSender {
  return caller.kind === 'client'
    ? { sender: `client ${caller.clientId}`, clientId: caller.clientId }
    : { sender: `place ${place}`, clientId: '' };
}

/** What uploads work with. */
export interface RecordingUploadsContext {
  readonly limits: LimitWatch;
  readonly recorder: Recorder;
  readonly atNodes: NodeRecordings;
  readonly room: RecordingRoom;
  readonly jobOf: (wish: UploadWish) => RecordingJob;
}

/** Files that become recordings: of people, and of nodes that recorded. */
export class RecordingUploads {
  readonly #context: RecordingUploadsContext;
  readonly #space: UploadSpace;

  constructor(context: RecordingUploadsContext) {
    this.#context = context;
    const { limits, room } = context;
    this.#space = new UploadSpace({ limits, roomBeyond: (bytes) => room.require(bytes) });
  }

  /** [RC-41] @throws ServiceError when the upload is too large or no recording */
  take(upload: Upload, wish: UploadWish, sender: UploadSender): Promise<Recording> {
    const { recorder, jobOf } = this.#context;
    const { id, isAwaited } = upload;
    return this.#space.hold({ ...upload, ...sender }, async () => {
      const recording = await recorder.adopt({ ...jobOf(wish), id, name: wish.name });
      if (isAwaited()) return recording;
      // Its sender takes it for failed, and may send it again. [RC-42]
      await recorder.delete(id);
      throw new ServiceError('deadline_exceeded', 'The upload was closed before it was checked.');
    });
  }

  /** The same for what a node recorded. [RC-63] */
  async takeOfNode(upload: NodeUpload, caller: Caller): Promise<Recording> {
    const { recorder, atNodes, jobOf } = this.#context;
    const { recordingId: id, clientId } = upload;
    const known = await recorder.get(id).catch(() => undefined);
    if (known !== undefined) {
      throw new ServiceError('already_exists', 'The master has this recording already.');
    }
    const wish = atNodes.requireUpload(id, clientId, caller);
    return this.#space.hold({ ...upload, sender: `client ${clientId}` }, async () => {
      const job = { ...jobOf({ ...wish, notes: '' }), id, isOfNode: true };
      const recording = await recorder.adopt(job);
      atNodes.handleUploaded(id);
      return recording;
    });
  }
}
