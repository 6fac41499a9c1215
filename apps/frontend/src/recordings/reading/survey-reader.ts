import type { RecordsReader } from '@ubii/recording';
import { trackKind } from '../timeline/track-entry.ts';
import { SurveyBuilder, type Survey } from '../timeline/survey.ts';
import { formatLook } from '../../formats/families.ts';
import { decodeRecorded } from './decode-recorded.ts';
import type { ReadTurn } from './read-turns.ts';
import { TimeBase } from './recording-time-base.ts';

/** After how much reading the first part is shown, milliseconds; later parts take longer and longer. */
const FIRST_PART_MS = 250;
/** Reads a whole recording, and shows it while that takes. */
export async function readSurvey(
  reader: RecordsReader,
  turn: ReadTurn,
  nowMs: () => number,
  show: (survey: Survey) => void,
): Promise<void> {
  const { startNs, endNs, topics } = reader.summary;
  const base = new TimeBase(startNs);
  const builder = new SurveyBuilder(base.toMs(endNs));
  /** Pictures are only counted: decoding them all would take as long as they took. */
  const undecoded = new Map(
    topics.flatMap(({ topic, format, isRaw }) =>
      isRaw || trackKind(formatLook(format).format) === 'frames' ? [[topic, isRaw] as const] : [],
    ),
  );
  let partMs = FIRST_PART_MS;
  let shownMs = nowMs();
  for await (const { topic, record, logTimeNs } of reader.records({ isOnce: true })) {
    const isRaw = undecoded.get(topic);
    if (isRaw === false) builder.addFrame(topic, base.toMs(logTimeNs));
    else
      builder.add(
        topic,
        base.toMs(logTimeNs),
        isRaw === true ? undefined : decodeRecorded(topic, record),
      );
    const giveWay = turn.next();
    if (giveWay === undefined) continue;
    await giveWay;
    if (nowMs() - shownMs <= partMs) continue;
    show(builder.survey(false));
    partMs *= 2;
    shownMs = nowMs();
  }
  show(builder.survey(true));
}
