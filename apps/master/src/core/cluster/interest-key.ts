import type { ClusterInterest } from '@ubii/proto';
import { selectionKey } from '../topics/component-selection.ts';

/** Equal for what is the same, at whatever rate. */
export function interestKey({
  topic,
  pattern,
  profile,
  everything,
}: Omit<ClusterInterest, 'maxRateHz'>): string {
  if (everything) return 'everything';
  if (profile !== undefined) return `profile ${selectionKey(profile)}`;
  return pattern === '' ? `topic ${topic}` : `pattern ${pattern}`;
}
