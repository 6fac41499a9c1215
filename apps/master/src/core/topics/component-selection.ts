import { matchesProfile, type Component } from '@ubii/proto';
import type { Account } from '../shares/account.ts';
import type { SharedSelection, Subscriber, TopicEntry } from './topic-entry.ts';

/** One component profile with the topics it selects, shared by all who subscribed to it [TD-27]. */
export class ComponentSelection implements SharedSelection {
  readonly key: string;
  readonly profile: Component;
  /** Subscribers with their rates in Hz (0: every record). */
  readonly subscribers = new Map<Subscriber, number>();
  /** Selected topics, with the number of components that publish there. */
  readonly topics = new Map<string, number>();
  /** The entries of those topics that exist. */
  readonly entries = new Set<TopicEntry>();
  /** The account that it counts for [AC-80]. */
  payer: Account | undefined = undefined;

  constructor(key: string, profile: Component) {
    this.key = key;
    this.profile = profile;
  }

  selects(component: Component): boolean {
    return component.topic !== '' && matchesProfile(component, this.profile);
  }
}

/** Key of a profile: equal for equivalent profiles, which are the same subscription. */
export function selectionKey(profile: Component): string {
  const { id, name, messageFormat, deviceId, tags, ioType } = profile;
  return JSON.stringify([id, name, messageFormat, deviceId, [...tags].sort(), ioType]);
}
