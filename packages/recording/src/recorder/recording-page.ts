import type { Recording, TextLimits } from '@ubii/proto';
import type { Marker } from '../records/recording-event.ts';
import { describeTopic, type DescribedTopic } from './file-facts.ts';
import { describeMarker } from './marker-list.ts';
import type { RecordingPage } from './recorder.ts';

/** Elements of one page, of topics and of markers each. */
const MAX_PAGE_ELEMENTS = 1_000;
/** Bytes of the topics of a page, and of the markers: with all else of a recording less than 1 MiB. */
const MAX_PAGE_BYTES = 320 * 1024;

/** All topics and markers of a recording. */
interface PagedParts {
  readonly topics: readonly DescribedTopic[];
  readonly markers: readonly Marker[];
}

/** One page of topics and markers. [RC-54] @param id of the recording */
export function pageOf(
  id: string,
  { topics, markers }: PagedParts,
  page: RecordingPage,
  limits: TextLimits,
): Pick<Recording, 'topics' | 'topicsFrom' | 'topicsTotal' | 'markers' | 'markersFrom'> {
  const topicsFrom = Math.max(0, page.topicsFrom);
  const markersFrom = Math.max(0, page.markersFrom);
  return {
    topicsFrom,
    topicsTotal: topics.length,
    markersFrom,
    topics: elementsFrom(topics, topicsFrom, (topic) => describeTopic(topic, limits)),
    markers: elementsFrom(markers, markersFrom, (marker) => describeMarker(id, marker, limits)),
  };
}

/** As many elements as a page holds, one at least. */
export function elementsFrom<T, E>(all: readonly T[], from: number, describe: (one: T) => E): E[] {
  const page: E[] = [];
  let bytes = 0;
  for (const one of all.slice(from, from + MAX_PAGE_ELEMENTS)) {
    const element = describe(one);
    bytes += new TextEncoder().encode(JSON.stringify(element)).length;
    if (bytes > MAX_PAGE_BYTES && page.length > 0) break;
    page.push(element);
  }
  return page;
}
