import { RecordingKind, RecordingState, type Recording } from '@ubii/proto';
import { changeRecording, repairRecording } from '../repair/repair-recording.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import { READING_LIMITS } from '../storage/reading-limits.ts';
import type { RecordingTexts, RunningJob } from './recorder.ts';
import {
  AT_MASTER,
  factsOf,
  formatHeader,
  WITHOUT_PAGE,
  type DescribedTopic,
  type FileFacts,
} from './file-facts.ts';
import { MarkerList } from './marker-list.ts';
import type { OpenFile } from './recording-folder.ts';

/** The rest is for markers that are added later. */
const MAX_INDEX_BYTES = 0.9 * READING_LIMITS.indexBytes;

/** A recording whose file is being written. */
export class RunningRecording {
  readonly job: RunningJob;
  readonly markers: MarkerList;
  readonly #file: OpenFile;
  readonly #writer: RecordingWriter;
  #facts: FileFacts;
  #isChanged = false;
  #lost = 0;
  #waiting: Promise<void> | undefined = undefined;

  private constructor(
    job: RunningJob,
    parts: { file: OpenFile; writer: RecordingWriter; facts: FileFacts; maxMarkers: number },
  ) {
    this.job = job;
    this.#file = parts.file;
    this.#writer = parts.writer;
    this.#facts = parts.facts;
    this.markers = new MarkerList([], parts.maxMarkers);
  }

  /** @throws the error of the file */
  static async create(
    job: RunningJob,
    file: OpenFile,
    startedMs: number,
    maxMarkers: number,
  ): Promise<RunningRecording> {
    const kind =
      job.replayedRecordingId === undefined
        ? RecordingKind.RECORDING_KIND_RECORDING
        : RecordingKind.RECORDING_KIND_COMPARISON;
    const facts = factsOf(job, kind, startedMs, job.selection);
    const writer = await RecordingWriter.create(file, formatHeader(facts));
    for (const event of job.present) writer.addEvent(event);
    return new RunningRecording(job, { file, writer, facts, maxMarkers });
  }

  get sizeBytes(): number {
    return this.#writer.statistics.bytes;
  }

  /** The index of a file has a limit, so that it can be read again. [RC-16] */
  get isIndexFull(): boolean {
    return this.#writer.statistics.indexBytes > MAX_INDEX_BYTES;
  }

  get startedMs(): number {
    return this.#facts.startedMs;
  }

  /** @throws the error of the file */
  addRecord(record: RecordedRecord): void {
    this.#waiting = this.#writer.addRecord(record) ?? this.#waiting;
  }

  /** @throws the error of the file */
  addEvent(event: RecordingEvent): void {
    if (event.kind === 'gap') this.#lost += event.value.records;
    this.#writer.addEvent(event);
  }

  /** Waits until the file took what it was given. @throws the error of the file */
  async taken(): Promise<void> {
    const waiting = this.#waiting;
    this.#waiting = undefined;
    await waiting;
  }

  /** @throws the error of the file */
  flush(): Promise<void> {
    return this.#writer.flush();
  }

  change({ name, notes }: RecordingTexts): void {
    this.#facts = { ...this.#facts, name, notes };
    this.#isChanged = true;
  }

  /** Closes the file. @param problem why it stopped by itself @throws the error of the file */
  async finish(problem = ''): Promise<void> {
    await this.#writer.end();
    if (problem !== '' || this.#isChanged) {
      const header = formatHeader({ ...this.#facts, problem });
      await changeRecording(this.#file, { header });
    }
    await this.#file.close();
  }

  /** Keeps what was written before the file failed. [RC-17] */
  async salvage(problem: string): Promise<void> {
    const header = formatHeader({
      ...this.#facts,
      problem,
      state: RecordingState.RECORDING_STATE_FAILED,
    });
    try {
      await repairRecording(this.#file);
      await changeRecording(this.#file, { header });
    } finally {
      await this.#file.close();
    }
  }

  /** Statistics of each topic so far. */
  get topics(): readonly DescribedTopic[] {
    return this.#writer.topics;
  }

  toMessage(nowMs: number): Recording {
    const { job, startedMs } = this;
    const { records, topics, bytes } = this.#writer.statistics;
    const { name, notes, kind, replayedRecordingId } = this.#facts;
    return {
      id: job.id,
      name,
      notes,
      kind,
      startedMs,
      problem: '',
      state: RecordingState.RECORDING_STATE_RECORDING,
      durationMs: nowMs - startedMs,
      sizeBytes: bytes,
      recordCount: records,
      lostCount: this.#lost + this.#writer.statistics.refusedRecords,
      topicCount: topics,
      markerCount: this.markers.size,
      author: job.author,
      selection: job.selection,
      study: job.study,
      budget: job.budget,
      ...WITHOUT_PAGE,
      replayedRecordingId,
      ...AT_MASTER,
    };
  }
}
