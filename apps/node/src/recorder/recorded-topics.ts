import type { EncodedRecord, UbiiClient } from '@ubii/client-web/node';
import { compileGlob } from '@ubii/patterns';
import { isMasterTopic, type NodeRecorderSource, type RecordingSelection } from '@ubii/proto';
import { describeRecord } from '@ubii/recording';
import { isInternalTopic } from '@ubii/recording/recorder';

type TopicTest = (topic: string) => boolean;

/** What a node receives for one recording: it compares topics and globs, and the master names the rest. [RC-61] */
export class RecordedTopics {
  readonly #client: UbiiClient;
  readonly #selection: RecordingSelection;
  readonly #onRecord: (record: EncodedRecord) => void;
  readonly #isAll: boolean;
  readonly #globs: readonly TopicTest[];
  readonly #excluded: readonly TopicTest[];
  /** Publishers that the master named, by topic. */
  readonly #sources = new Map<string, Set<string>>();
  readonly #ends: (() => void)[] = [];

  constructor(
    client: UbiiClient,
    selection: RecordingSelection,
    onRecord: (record: EncodedRecord) => void,
  ) {
    const { topics, patterns, clients, devices, sessions } = selection;
    const named = [topics, patterns, clients, devices, sessions];
    this.#client = client;
    this.#selection = selection;
    this.#onRecord = onRecord;
    this.#isAll = named.every((list) => list.length === 0);
    const globs = this.#isAll ? ['/**'] : patterns;
    this.#globs = globs.map((glob) => compileGlob(glob));
    this.#excluded = selection.excludedPatterns.map((glob) => compileGlob(glob));
    globs.forEach((glob, index) => {
      const before = this.#globs.slice(0, index);
      // What two globs match comes once for each: the first one takes it.
      this.#subscribe({ glob }, ({ topic }) => !before.some((matches) => matches(topic)));
    });
    for (const topic of new Set(topics)) this.#subscribeTopic(topic);
  }

  /** More that is recorded. */
  add(sources: readonly NodeRecorderSource[]): void {
    for (const { topic, clientId } of sources) {
      const publishers = this.#sources.get(topic);
      if (publishers !== undefined) publishers.add(clientId);
      else {
        this.#sources.set(topic, new Set([clientId]));
        if (!this.#selection.topics.includes(topic)) this.#subscribeTopic(topic);
      }
    }
  }

  close(): void {
    for (const end of this.#ends) end();
  }

  #subscribeTopic(topic: string): void {
    if (!this.#globs.some((matches) => matches(topic))) this.#subscribe(topic, () => true);
  }

  #subscribe(
    pattern: string | { glob: string },
    isFirst: (record: EncodedRecord) => boolean,
  ): void {
    const onRecord = (record: EncodedRecord): void => {
      if (isFirst(record) && this.#isChosen(record)) this.#onRecord(record);
    };
    this.#ends.push(this.#client.subscribeEncoded(pattern, { onRecord, onGone: () => undefined }));
  }

  /** [RC-10] [RC-12] [RC-13] */
  #isChosen({ topic, publisherId, bytes }: EncodedRecord): boolean {
    if (isMasterTopic(topic) || this.#excluded.some((matches) => matches(topic))) return false;
    const isNamed = this.#isAll
      ? !isInternalTopic(topic, publisherId)
      : this.#selection.topics.includes(topic) ||
        this.#globs.some((matches) => matches(topic)) ||
        this.#sources.get(topic)?.has(publisherId) === true;
    return isNamed && !(this.#selection.withoutImages && isImage(bytes));
  }
}

function isImage(bytes: Uint8Array): boolean {
  const { format } = describeRecord(bytes);
  return format === 'image2D' || format === 'image2DList';
}
