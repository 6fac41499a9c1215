import { ComponentIOType, type Component } from '@ubii/proto';
import { ComponentSelection, selectionKey } from './component-selection.ts';
import type { TopicEntry } from './topic-entry.ts';
import type { TopicMatching } from './topic-table.ts';

/** All component profiles with a subscription, and the topics that they select [TD-27]. */
export class SelectionTable implements TopicMatching {
  readonly #selections = new Map<string, ComponentSelection>();
  readonly #byTopic = new Map<string, Set<ComponentSelection>>();
  /** Every registered component that publishes. */
  readonly #components = new Set<Component>();

  get size(): number {
    return this.#selections.size;
  }

  get(profile: Component): ComponentSelection | undefined {
    return this.#selections.get(selectionKey(profile));
  }

  /**
   * Adds a profile that is not there yet, and finds the topics it selects.
   * @param entryOf Finds the entry of a topic that exists.
   */
  create(
    profile: Component,
    entryOf: (topic: string) => TopicEntry | undefined,
  ): ComponentSelection {
    const selection = new ComponentSelection(selectionKey(profile), profile);
    this.#selections.set(selection.key, selection);
    for (const component of this.#components) {
      this.#select(selection, component, entryOf(component.topic));
    }
    return selection;
  }

  forgetIfUnused(selection: ComponentSelection): void {
    if (selection.subscribers.size > 0) return;
    this.#selections.delete(selection.key);
    for (const topic of selection.topics.keys()) this.#unlinkTopic(selection, topic);
    for (const entry of selection.entries) this.#unlinkEntry(selection, entry);
  }

  /** Links the selections that select this new component to its topic. Returns those that newly have the topic. */
  addComponent(component: Component, entry: TopicEntry | undefined): ComponentSelection[] {
    if (!publishes(component)) return [];
    this.#components.add(component);
    return [...this.#selections.values()].filter((selection) =>
      this.#select(selection, component, entry),
    );
  }

  /** The component is gone. Returns the selections that no longer have its topic. */
  removeComponent(component: Component, entry: TopicEntry | undefined): ComponentSelection[] {
    if (!this.#components.delete(component)) return [];
    const lost: ComponentSelection[] = [];
    for (const selection of this.#byTopic.get(component.topic) ?? []) {
      if (!selection.selects(component)) continue;
      const count = selection.topics.get(component.topic)! - 1;
      if (count > 0) selection.topics.set(component.topic, count);
      else {
        selection.topics.delete(component.topic);
        this.#unlinkTopic(selection, component.topic);
        if (entry !== undefined) this.#unlinkEntry(selection, entry);
        lost.push(selection);
      }
    }
    return lost;
  }

  attach(entry: TopicEntry): void {
    for (const selection of this.#byTopic.get(entry.topic) ?? []) link(selection, entry);
  }

  detach(entry: TopicEntry): void {
    for (const selection of entry.selections) selection.entries.delete(entry);
  }

  #select(
    selection: ComponentSelection,
    component: Component,
    entry: TopicEntry | undefined,
  ): boolean {
    if (!selection.selects(component)) return false;
    const { topic } = component;
    const count = selection.topics.get(topic) ?? 0;
    selection.topics.set(topic, count + 1);
    if (count > 0) return false;
    const selections = this.#byTopic.get(topic);
    if (selections === undefined) this.#byTopic.set(topic, new Set([selection]));
    else selections.add(selection);
    if (entry !== undefined) link(selection, entry);
    return true;
  }

  #unlinkTopic(selection: ComponentSelection, topic: string): void {
    const selections = this.#byTopic.get(topic);
    selections?.delete(selection);
    if (selections?.size === 0) this.#byTopic.delete(topic);
  }

  #unlinkEntry(selection: ComponentSelection, entry: TopicEntry): void {
    selection.entries.delete(entry);
    entry.selections = entry.selections.filter((other) => other !== selection);
  }
}

function publishes(component: Component): boolean {
  return component.ioType !== ComponentIOType.SUBSCRIBER && component.topic !== '';
}

function link(selection: ComponentSelection, entry: TopicEntry): void {
  entry.selections.push(selection);
  selection.entries.add(entry);
}
