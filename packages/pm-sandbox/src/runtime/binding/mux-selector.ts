import { globToRegExpSource, type TopicMux } from '@ubii/proto';
import type { TopicSelector } from '../../ports/topic-port.ts';

/**
 * Which topics a muxer selects: a profile wins over a glob, a glob over an expression. [PM-41]
 *
 * @returns undefined when it has none of them
 */
export function muxSelector(
  mux: Pick<TopicMux, 'component' | 'topicGlob' | 'topicSelector'>,
): TopicSelector | undefined {
  if (mux.component !== undefined) return { kind: 'component', profile: mux.component };
  if (mux.topicGlob !== '') return { kind: 'glob', glob: mux.topicGlob };
  if (mux.topicSelector !== '') return { kind: 'regex', source: mux.topicSelector };
  return undefined;
}

/** Source of the expression a selector is, or undefined when topics alone do not tell. */
export function selectorSource(selector: TopicSelector): string | undefined {
  if (selector.kind === 'glob') return globToRegExpSource(selector.glob);
  return selector.kind === 'regex' ? selector.source : undefined;
}
