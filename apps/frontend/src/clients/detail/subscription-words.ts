import type { ClientSubscription, Component } from '@ubii/proto';
import { formatRate } from '../../ui/readouts/format-rate.ts';

/** A subscription as a line of text. */
export interface SubscriptionLine {
  readonly kind: 'topic' | 'pattern' | 'component';
  readonly text: string;
  /** Highest rate; empty for every record. */
  readonly limit: string;
}

export function subscriptionLine(subscription: ClientSubscription): SubscriptionLine {
  const { topic, pattern, component, maxRateHz } = subscription;
  const limit = maxRateHz > 0 ? `at most ${formatRate(maxRateHz)} Hz` : '';
  if (pattern !== '') return { kind: 'pattern', text: pattern, limit };
  if (component !== undefined) return { kind: 'component', text: profileWords(component), limit };
  return { kind: 'topic', text: topic, limit };
}

/** Properties that a component must have: the members of the profile that are not empty. */
function profileWords({ name, messageFormat, topic, tags, description }: Component): string {
  const parts = [
    name && `name ${name}`,
    messageFormat && `format ${messageFormat}`,
    topic && `topic ${topic}`,
    tags.length > 0 && `tags ${tags.join(', ')}`,
    description && `description ${description}`,
  ].filter(Boolean);
  return parts.length === 0 ? 'any component' : parts.join(', ');
}
