import type { ClientSubscription, Component } from '@ubii/proto';
import { formatRate } from '../../ui/readouts/format-rate.ts';

/** A subscription as a line. */
export interface SubscriptionLine {
  readonly kind: 'topic' | 'pattern' | 'component';
  readonly text: string;
  /** At most how often; empty for every record. */
  readonly limit: string;
}

export function subscriptionLine(subscription: ClientSubscription): SubscriptionLine {
  const { topic, pattern, component, maxRateHz } = subscription;
  const limit = maxRateHz > 0 ? `at most ${formatRate(maxRateHz)} Hz` : '';
  if (pattern !== '') return { kind: 'pattern', text: pattern, limit };
  if (component !== undefined) return { kind: 'component', text: profileWords(component), limit };
  return { kind: 'topic', text: topic, limit };
}

/** What a component has to be like: the members that are not empty. */
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
