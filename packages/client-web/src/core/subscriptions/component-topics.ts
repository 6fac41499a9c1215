import type { Component, Device } from '@ubii/proto';
import { ComponentIOType, isMasterTopic } from '@ubii/proto';
import { selectsComponent } from './component-profile.ts';
import type { ComponentProfile } from './component-profile.ts';
import type { ReceivedRecord } from './received-record.ts';

/** Records that wait for an answer to what topics there are; more are let go, oldest first. */
const MAX_HELD_RECORDS = 256;
/** Topics known to belong to no profile; beyond that they are asked for again. */
const MAX_FOREIGN_TOPICS = 10_000;

/** Dependencies and callbacks of the component topics. */
export interface ComponentTopicsOptions {
  /** Components that match any of the profiles. */
  readonly listComponents: (profiles: readonly ComponentProfile[]) => Promise<readonly Component[]>;
  /** The topics of a profile changed. */
  readonly handleChange: () => void;
  /** A record came before it was known whether its topic belongs to a profile. It is known now. */
  readonly handleRecord: (record: ReceivedRecord) => void;
}

/**
 * Maps component profiles to topics. The master delivers by profile [TD-27], but records do not name the profile, so
 * the client has to know the topics. It learns them from the list of components, from announcements of new devices,
 * and, for a record on an unknown topic, by requesting the list again; the record waits for the reply.
 */
export class ComponentTopics {
  readonly #options: ComponentTopicsOptions;
  readonly #profiles = new Map<string, { profile: ComponentProfile; topics: Set<string> }>();
  readonly #foreignTopics = new Set<string>();
  #heldRecords: ReceivedRecord[] = [];
  #refreshing: Promise<void> | undefined;
  #isStale = false;

  constructor(options: ComponentTopicsOptions) {
    this.#options = options;
  }

  add(key: string, profile: ComponentProfile): void {
    this.#profiles.set(key, { profile, topics: new Set() });
    this.#foreignTopics.clear();
  }

  remove(key: string): void {
    this.#profiles.delete(key);
  }

  /** Whether a topic belongs to the profile of this key, as far as is known. */
  has(key: string, topic: string): boolean {
    return this.#profiles.get(key)?.topics.has(topic) === true;
  }

  clear(): void {
    this.#profiles.clear();
    this.#foreignTopics.clear();
    this.#heldRecords = [];
  }

  /** Every topic that belongs to a profile. */
  topics(): Set<string> {
    return new Set([...this.#profiles.values()].flatMap(({ topics }) => [...topics]));
  }

  /** Whether it is not known yet if the topic belongs to a profile. */
  isUnknown(topic: string): boolean {
    if (this.#profiles.size === 0 || this.#foreignTopics.has(topic)) return false;
    if (isMasterTopic(topic)) return false;
    for (const { topics } of this.#profiles.values()) if (topics.has(topic)) return false;
    return true;
  }

  /** Keeps a record of an unknown topic until it is known whether it belongs to a profile. */
  hold(record: ReceivedRecord): void {
    this.#heldRecords.push(record);
    if (this.#heldRecords.length > MAX_HELD_RECORDS) this.#heldRecords.shift();
    if (this.#refreshing !== undefined && this.#isStale) return;
    void this.refresh().catch(() => undefined); // asked again with the next such record
  }

  /** A device was announced. */
  handleNewDevice(device: Device): void {
    if (this.#refreshing !== undefined) this.#isStale = true; // the answer may be older than this
    if (this.#addMatches(device.components)) this.#options.handleChange();
  }

  /** Asks the master what components there are. Calls meanwhile share one more request. */
  async refresh(): Promise<void> {
    this.#isStale = true;
    this.#refreshing ??= this.#refreshAll().finally(() => {
      this.#refreshing = undefined;
    });
    await this.#refreshing;
  }

  async #refreshAll(): Promise<void> {
    while (this.#isStale && this.#profiles.size > 0) {
      this.#isStale = false;
      const profiles = [...this.#profiles.values()].map(({ profile }) => profile);
      const held = this.#heldRecords.at(-1);
      const components = await this.#options.listComponents(profiles);
      for (const { topics } of this.#profiles.values()) topics.clear();
      this.#addMatches(components);
      this.#options.handleChange();
      this.#releaseRecords(held);
    }
  }

  /**
   * Delivers what belongs to a profile. Of the rest, those up to `lastAsked` came before the
   * question was asked, so the answer says that they belong to none.
   */
  #releaseRecords(lastAsked: ReceivedRecord | undefined): void {
    const topics = this.topics();
    const records = this.#heldRecords;
    const asked = lastAsked === undefined ? -1 : records.lastIndexOf(lastAsked);
    this.#heldRecords = [];
    records.forEach((record, index) => {
      if (topics.has(record.topic)) this.#options.handleRecord(record);
      else if (index > asked) this.#heldRecords.push(record);
      else this.#noteForeign(record.topic);
    });
  }

  #noteForeign(topic: string): void {
    if (this.#foreignTopics.size >= MAX_FOREIGN_TOPICS) this.#foreignTopics.clear();
    this.#foreignTopics.add(topic);
  }

  #addMatches(components: readonly Component[]): boolean {
    let hasChanged = false;
    for (const component of components) {
      if (component.ioType !== ComponentIOType.PUBLISHER || component.topic === '') continue;
      for (const { profile, topics } of this.#profiles.values()) {
        if (topics.has(component.topic) || !selectsComponent(profile, component)) continue;
        topics.add(component.topic);
        this.#foreignTopics.delete(component.topic);
        hasChanged = true;
      }
    }
    return hasChanged;
  }
}
