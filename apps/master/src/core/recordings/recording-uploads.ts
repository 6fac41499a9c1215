import { ServiceError, type Recording } from '@ubii/proto';
import type { Recorder, RecordingJob } from '@ubii/recording/recorder';
import type { Caller } from '../access/caller.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { NodeRecordings } from './node-recordings.ts';
import type { RecordingRoom } from './recording-room.ts';
import { UploadSpace } from './upload-space.ts';

/** A file that is uploaded. */
export interface Upload {
  /** Of the recording that it becomes. */
  readonly id: string;
  /** Size that it claims, bytes; 0 when it is unknown. */
  readonly declaredBytes: number;
  /** Stores it; calls `take` for each part before, which rejects when there is no space. Nothing is kept when it fails. */
  readonly receive: (take: (bytes: number) => Promise<void>) => Promise<void>;
}

/** The file of a recording that a node made. [RC-63] */
export interface NodeUpload extends Omit<Upload, 'id'> {
  readonly recordingId: string;
  /** Id of the client that brings it, as it says. */
  readonly clientId: string;
}

/** What a recording of an upload is called, whose it is, and what it belongs to. */
export type UploadWish = Pick<
  RecordingJob,
  'name' | 'notes' | 'author' | 'makerId' | 'study' | 'replayedRecordingId' | 'keepsStudy'
>;

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
  async take({ id, declaredBytes, receive }: Upload, wish: UploadWish): Promise<Recording> {
    const { recorder, jobOf } = this.#context;
    await this.#space.hold(declaredBytes, receive);
    return recorder.adopt({ ...jobOf(wish), id, name: wish.name });
  }

  /** The same for what a node recorded. [RC-63] */
  async takeOfNode(upload: NodeUpload, caller: Caller): Promise<Recording> {
    const { recorder, atNodes, jobOf } = this.#context;
    const { recordingId: id, clientId, receive, declaredBytes } = upload;
    const known = await recorder.get(id).catch(() => undefined);
    if (known !== undefined) {
      throw new ServiceError('already_exists', 'The master has this recording already.');
    }
    const wish = atNodes.requireUpload(id, clientId, caller);
    await this.#space.hold(declaredBytes, receive);
    const recording = await recorder.adopt({
      ...jobOf({ ...wish, notes: '' }),
      id,
      isOfNode: true,
    });
    atNodes.handleUploaded(id);
    return recording;
  }
}
