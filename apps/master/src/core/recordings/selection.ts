import { compileGlob } from '@ubii/patterns';
import type { CompiledPattern, PatternCompiler } from '@ubii/patterns';
import { DATA_FORMATS, matchesProfile, type Component, type RecordingSelection } from '@ubii/proto';
import { isInternalTopic } from '@ubii/recording/recorder';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { DeviceRegistry } from '../devices/device-registry.ts';
import type { Session } from '../sessions/session.ts';

/** The selection that has all topics. [RC-10] */
export const EVERYTHING: RecordingSelection = {
  topics: [],
  patterns: [],
  clients: [],
  devices: [],
  sessions: [],
  excludedPatterns: [],
  withoutImages: false,
};

/** What a selection is compared with. */
export interface SelectionContext {
  readonly patterns: PatternCompiler;
  readonly clients: ClientRegistry;
  readonly devices: DeviceRegistry;
  readonly sessions: () => readonly Session[];
}

type TopicTest = (topic: string) => boolean;

/** Placeholders of the topics of a demultiplexer. */
const PLACEHOLDER = '{{#';
const IMAGE_FIELDS: ReadonlySet<number> = new Set([
  DATA_FORMATS.image2D.fieldNumber,
  DATA_FORMATS.image2DList.fieldNumber,
]);

/** Whether a record with this value is an image or a list of them. */
export function isImageField(valueField: number): boolean {
  return IMAGE_FIELDS.has(valueField);
}

/** A selection, ready to be compared with topics and their publishers. [RC-10] [RC-13] */
export class CompiledSelection {
  readonly withoutImages: boolean;
  /** As it was written. */
  readonly selection: RecordingSelection;
  readonly #context: SelectionContext;
  readonly #isAll: boolean;
  readonly #globs: readonly TopicTest[];
  readonly #excluded: readonly TopicTest[];
  /** Topics of the graphs of sessions; `undefined` until they are needed, and when a session has changed. */
  #ofSessions: readonly TopicTest[] | undefined = undefined;

  constructor(selection: RecordingSelection, context: SelectionContext) {
    const { topics, patterns, clients, devices, sessions } = selection;
    const named = [topics, patterns, clients, devices, sessions];
    this.selection = selection;
    this.#context = context;
    this.#isAll = named.every((list) => list.length === 0);
    this.#globs = patterns.map(compileGlob);
    this.#excluded = selection.excludedPatterns.map(compileGlob);
    this.withoutImages = selection.withoutImages;
  }

  /** Sessions, devices or names of clients have changed. [RC-11] */
  refresh(): void {
    this.#ofSessions = undefined;
  }

  /** Whether it selects what this client publishes on the topic. */
  selects(topic: string, publisherId: string): boolean {
    if (this.#excluded.some((test) => test(topic))) return false;
    return (
      (this.#isAll && !isInternalTopic(topic, publisherId)) ||
      this.selection.topics.includes(topic) ||
      this.#globs.some((test) => test(topic)) ||
      this.#selectsClient(publisherId) ||
      this.#selectsDevice(topic) ||
      this.#sessionTopics().some((test) => test(topic))
    );
  }

  #selectsClient(id: string): boolean {
    const { clients } = this.selection;
    if (clients.length === 0 || id === '') return false;
    const name = this.#context.clients.get(id)?.spec.name;
    return clients.includes(id) || (name !== undefined && name !== '' && clients.includes(name));
  }

  #selectsDevice(topic: string): boolean {
    const { devices: wanted } = this.selection;
    if (wanted.length === 0) return false;
    const { devices } = this.#context;
    return devices.publishersOf(topic).some(({ deviceId, tags }) => {
      const device = devices.get(deviceId);
      const words = [...tags, ...(device?.tags ?? []), device?.name ?? ''];
      return words.some((word) => word !== '' && wanted.includes(word));
    });
  }

  #sessionTopics(): readonly TopicTest[] {
    const { sessions: wanted } = this.selection;
    if (wanted.length === 0) return [];
    this.#ofSessions ??= this.#context
      .sessions()
      .filter(({ id, description }) => wanted.includes(id) || wanted.includes(description.name))
      .flatMap((session) => this.#topicsOf(session));
    return this.#ofSessions;
  }

  #topicsOf({ modules }: Session): TopicTest[] {
    return modules.flatMap(({ mapping: { inputMappings, outputMappings } }) => [
      ...inputMappings.flatMap(({ topic, topicMux }) => {
        if (topic) return [isTopic(topic)];
        if (topicMux?.topicGlob) return [compileGlob(topicMux.topicGlob)];
        if (topicMux?.component) return [this.#isOfComponent(topicMux.component)];
        return topicMux?.topicSelector ? this.#expression(topicMux.topicSelector) : [];
      }),
      ...outputMappings.flatMap(({ topic, topicDemux }) => {
        if (topic) return [isTopic(topic)];
        const format = topicDemux?.outputTopicFormat ?? '';
        return format === '' ? [] : [compileGlob(globOf(format))];
      }),
    ]);
  }

  #isOfComponent(profile: Component): TopicTest {
    const { devices } = this.#context;
    return (topic) => devices.publishersOf(topic).some((each) => matchesProfile(each, profile));
  }

  #expression(source: string): TopicTest[] {
    let pattern: CompiledPattern;
    try {
      pattern = this.#context.patterns.compile(source);
    } catch {
      return []; // The session has a problem that says so.
    }
    return [(topic) => pattern.test(topic)];
  }
}

function isTopic(topic: string): TopicTest {
  return (other) => other === topic;
}

/** The topics that a demultiplexer can publish on. */
function globOf(format: string): string {
  return format
    .split(PLACEHOLDER)
    .map((part, index) => (index === 0 ? part : `**${part.slice(part.indexOf('}}') + 2)}`))
    .join('');
}
