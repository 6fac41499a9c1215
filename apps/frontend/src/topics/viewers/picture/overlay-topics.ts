import { parseDataFormat } from '@ubii/proto';
import { isInternalTopic } from '../../names/internal-topics.ts';
import { PLANE_FORMATS } from '../plane/plane-shapes.ts';

const MAX_SUGGESTIONS = 30;

/**
 * Returns the topics that can be drawn over a picture, most likely first: objects and poses before points, and among
 * them those whose path starts like the picture's.
 */
export function overlayTopics(
  known: Iterable<readonly [topic: string, format: string]>,
  picture: string,
): string[] {
  const order = [...PLANE_FORMATS];
  const parts = picture.split('/');
  return [...known]
    .flatMap(([topic, text]) => {
      const format = parseDataFormat(text);
      if (format === undefined || !PLANE_FORMATS.has(format) || isInternalTopic(topic)) return [];
      const common = topic.split('/').findIndex((part, index) => part !== parts[index]);
      return [{ topic, rank: order.indexOf(format), common: common < 0 ? parts.length : common }];
    })
    .sort((a, b) => a.rank - b.rank || b.common - a.common || (a.topic < b.topic ? -1 : 1))
    .slice(0, MAX_SUGGESTIONS)
    .map(({ topic }) => topic);
}
