import type { MeteredPatterns } from '@ubii/patterns';
import type { TopicMux } from '@ubii/proto';
import type { TopicSelector } from '../../ports/topic-port.ts';

/**
 * Returns the selector of a muxer: a profile takes precedence over a glob, a glob over an expression. [PM-41]
 *
 * @returns undefined without any of them
 */
export function muxSelector(
  mux: Pick<TopicMux, 'component' | 'topicGlob' | 'topicSelector'>,
): TopicSelector | undefined {
  if (mux.component !== undefined) return { kind: 'component', profile: mux.component };
  if (mux.topicGlob !== '') return { kind: 'glob', glob: mux.topicGlob };
  if (mux.topicSelector !== '') return { kind: 'regex', source: mux.topicSelector };
  return undefined;
}

/**
 * Tells whether a topic is selected; undefined when topics alone do not tell.
 *
 * @throws Error with the reason when the expression is refused
 */
export function selectorMatch(
  selector: TopicSelector,
  patterns: MeteredPatterns,
): ((topic: string) => boolean) | undefined {
  switch (selector.kind) {
    case 'topic':
      return (topic) => topic === selector.topic;
    case 'glob':
      return patterns.compileGlob(selector.glob);
    case 'regex':
      return patterns.compile(selector.source).test;
    case 'component':
      return undefined;
  }
}
