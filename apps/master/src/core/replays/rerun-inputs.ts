import { decode, encode, type Component } from '@ubii/proto';
import type { RecordedSource, RecordedSources } from '../topics/recorded-sources.ts';
import type { SubscriptionTable } from '../topics/subscription-table.ts';

/** What the inputs of a session that runs again work with. */
export interface RerunInputsContext {
  readonly subscriptions: SubscriptionTable;
  readonly recordedSources: RecordedSources;
}

/** Topics that a muxer selects by its profile. */
export interface SelectedTopics {
  /** The only tag of the profile and of these components: nothing else selects them, and it selects nothing else. */
  readonly tag: string;
  /** As the session reads them. */
  readonly topics: readonly string[];
}

/** What modules on the master find at the inputs of a session that runs again: components, and who published. [RP-42] [RP-43] */
export class RerunInputs {
  readonly #context: RerunInputsContext;
  readonly #components: readonly Component[];
  readonly #sources: ReadonlyMap<string, RecordedSource>;
  #isOpen = false;

  constructor(
    context: RerunInputsContext,
    selected: readonly SelectedTopics[],
    sources: ReadonlyMap<string, RecordedSource>,
  ) {
    this.#context = context;
    this.#components = selected.flatMap(({ tag, topics }) =>
      topics.map((topic) => componentOf(topic, tag)),
    );
    this.#sources = sources;
  }

  open(): void {
    this.#isOpen = true;
    const { subscriptions, recordedSources } = this.#context;
    for (const component of this.#components) subscriptions.addComponent(component);
    for (const [topic, source] of this.#sources) recordedSources.add(topic, source);
  }

  close(): void {
    if (!this.#isOpen) return;
    this.#isOpen = false;
    const { subscriptions, recordedSources } = this.#context;
    for (const component of this.#components) subscriptions.removeComponent(component);
    for (const topic of this.#sources.keys()) recordedSources.delete(topic);
  }
}

function componentOf(topic: string, tag: string): Component {
  const type = 'ubii.devices.Component';
  return decode(type, encode(type, { topic, tags: [tag] }));
}
