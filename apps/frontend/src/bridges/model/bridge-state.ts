import type { MarkedState } from '../../ui/UiStateMark.vue';
import type { BridgeView } from './bridge-view.ts';

/** How a bridge is, as a mark, a word and a sentence. */
export interface BridgeState {
  readonly mark: MarkedState;
  readonly word: string;
  /** What is wrong and what happens next; empty when all is well. */
  readonly sentence: string;
}

export function bridgeState({
  isHere,
  report,
}: Pick<BridgeView, 'isHere' | 'report'>): BridgeState {
  if (!isHere) {
    return {
      mark: 'away',
      word: 'Left',
      sentence: 'This bridge has left. What is shown is the last that it reported.',
    };
  }
  if (report === undefined) {
    return {
      mark: 'away',
      word: 'Starting',
      sentence: 'The bridge has not reported its state yet.',
    };
  }
  switch (report.status) {
    case 'connected':
      if (!report.isStandingBy) return { mark: 'live', word: 'Connected', sentence: '' };
      return {
        mark: 'away',
        word: 'Standing by',
        sentence:
          'Another bridge with the same mappings passes them. This one takes over when it goes.',
      };
    case 'waiting':
      return { mark: 'warning', word: 'Retrying', sentence: retrySentence(report) };
    case 'connecting':
      return { mark: 'away', word: 'Connecting', sentence: `Connecting to ${report.system}` };
    case 'closed':
      return { mark: 'stopped', word: 'Closed', sentence: 'The bridge is ending.' };
  }
}

function retrySentence({ system, reason }: NonNullable<BridgeView['report']>): string {
  const why = reason === '' ? '' : `: ${reason.replace(/\.$/, '')}`;
  return `No connection to ${system}${why}. It retries until it succeeds.`;
}
