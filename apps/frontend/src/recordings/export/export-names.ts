import { fileName } from '../../files/text-file.ts';
import type { ExportFormat, ExportRequest } from './export-messages.ts';
import type { VideoKind } from './video-format.ts';

/** Each topic is a file of its own. */
export const isByTopic = (format: ExportFormat): boolean =>
  format === 'csv' || format === 'parquet' || format === 'video';

/** How a file of a format ends. @param video what the browser encodes, see `videoKind` */
export function extensionOf(format: ExportFormat, video: VideoKind = 'webm'): string {
  return format === 'video' ? video : format;
}

/**
 * Name of the file that is saved: several files are in one ZIP. It is asked for before the recording is read, so that where
 * personal data is replaced it tells nothing of the recording. [PD-19]
 */
export function exportName(
  { format, topics, name, personal }: ExportRequest,
  video: VideoKind,
): string {
  const base = personal ? 'Shared recording' : fileName(name) || 'recording';
  if (isByTopic(format) && topics.length > 1) return `${base} ${WORDS[format] ?? format}.zip`;
  const [topic = ''] = topics;
  const suffix = isByTopic(format) && !personal ? ` ${topicFileName(topic)}` : '';
  return `${base}${suffix}.${extensionOf(format, video)}`;
}

const WORDS: Partial<Record<ExportFormat, string>> = {
  csv: 'CSV',
  parquet: 'Parquet',
  video: 'video',
};

/** A topic as a name of a file. */
export function topicFileName(topic: string): string {
  return fileName(topic.replace(/^\/+/, '')) || 'topic';
}

/** Names of the files of topics, each once. */
export function topicFileNames(topics: readonly string[], extension: string): string[] {
  const taken = new Set<string>();
  return topics.map((topic) => {
    const base = topicFileName(topic);
    let name = `${base}.${extension}`;
    for (let i = 2; taken.has(name.toLowerCase()); i++) name = `${base} ${i}.${extension}`;
    taken.add(name.toLowerCase());
    return name;
  });
}
