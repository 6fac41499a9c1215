import { compileGlob } from '@ubii/patterns';
import { parseList } from '@ubii/program';
import { isMasterTopic } from '@ubii/proto';

/** Parses `--topics`: topics, and globs such as `/lab/**`. */
export function parseTopics(text: string): readonly string[] {
  const list = parseList(text);
  const isWrong = list.some((topic) => !topic.startsWith('/'));
  if (isWrong) throw new Error('topics that begin with "/", separated by commas, such as /lab/**');
  return list;
}

/** Tells whether a list of topics and globs contains a topic. An empty list contains all but the topics of the master. */
export function topicChoice(chosen: readonly string[]): (topic: string) => boolean {
  if (chosen.length === 0) return (topic) => !isMasterTopic(topic);
  const globs = chosen.map((glob) => compileGlob(glob));
  return (topic) => globs.some((matches) => matches(topic));
}
