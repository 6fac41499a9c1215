import type { DataFormat, Session } from '@ubii/proto';
import { formatLook } from '../../formats/families.ts';
import { mappedModule } from '../../sessions/words/mapping-words.ts';
import { seriesOf } from '../../topics/values/value-series.ts';

/** What the picture of a session shows. */
export type CardSource =
  | { readonly kind: 'picture'; readonly topic: string }
  /** Numbers over time. */
  | {
      readonly kind: 'line';
      readonly topic: string;
      readonly format: DataFormat;
      readonly label: string;
    }
  | { readonly kind: 'graph' };

/**
 * Chooses what a session shows of itself: the last topic with pictures, else the most watched topic with numbers, of
 * several the last one, which is what comes out of it, else its graph.
 *
 * @param watchers number of clients that receive a topic
 */
export function cardSource(session: Session, watchers: (topic: string) => number): CardSource {
  const outputs = session.processingModules.flatMap((module) =>
    mappedModule(module, session).outputs.flatMap(({ format, end }) =>
      end.kind === 'topic' ? [{ topic: end.topic, ...formatLook(format) }] : [],
    ),
  );
  const picture = outputs.findLast(({ family }) => family === 'image');
  if (picture) return { kind: 'picture', topic: picture.topic };
  const [line] = outputs
    .flatMap(({ topic, format }) =>
      format !== undefined && seriesOf(format)
        ? [{ topic, format, label: topic.slice(topic.lastIndexOf('/') + 1) }]
        : [],
    )
    .reverse()
    .sort((a, b) => watchers(b.topic) - watchers(a.topic));
  return line ? { kind: 'line', ...line } : { kind: 'graph' };
}
