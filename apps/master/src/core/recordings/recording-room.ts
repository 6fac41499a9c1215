import type { Recorder } from '@ubii/recording/recorder';
import type { LimitWatch } from '../counters/limit-watch.ts';

/** Room for further recordings among those that the master keeps. [RC-4] */
export class RecordingRoom {
  readonly #recorder: Pick<Recorder, 'list'>;
  readonly #limits: LimitWatch;

  constructor(recorder: Pick<Recorder, 'list'>, limits: LimitWatch) {
    this.#recorder = recorder;
    this.#limits = limits;
  }

  /**
   * Returns the bytes that are left.
   *
   * @param bytes that count as taken beside those of the files
   * @throws ServiceError when no further recording may be stored
   */
  async require(bytes = 0): Promise<number> {
    const { recordings, recordingsBytes } = this.#limits.limits;
    const { recordings: known, sizeBytes } = await this.#recorder.list();
    if (known.length >= recordings) {
      throw this.#limits.refusal('recordings', `more than ${recordings} recordings`);
    }
    const left = recordingsBytes - sizeBytes - bytes;
    if (left > 0) return left;
    const text = `more than ${recordingsBytes} bytes of recordings`;
    throw this.#limits.refusal('recordingsBytes', text);
  }
}
