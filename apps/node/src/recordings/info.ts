import { ConfigError, HELP_OPTIONS, switchOption } from '@ubii/program';
import type { OptionValues, ProgramOptions } from '@ubii/program';
import { repairRecording, type RecordedTopic, type RecordingSummary } from '@ubii/recording';
import { DiskFile } from '@ubii/recording/node';
import { counted } from '@ubii/words';
import { bytesText, durationText, openRecording } from './recording-words.ts';

const OPTIONS = {
  json: switchOption('Write the facts as JSON.'),
  repair: switchOption('Repair a file whose end is missing, in place, before it is described.'),
  ...HELP_OPTIONS,
} as const;

/** `npm run info` */
export const INFO_PROGRAM: ProgramOptions<typeof OPTIONS> = {
  options: OPTIONS,
  takesWords: true,
  about: `Ubi-Interact recordings: describes a recording, also one of another program that writes MCAP.

  npm run info -- <file.mcap> [flags]
`,
};

/** Describes a recording. @throws ConfigError when it cannot be read */
export async function info(
  [path, ...more]: readonly string[],
  { json, repair }: OptionValues<typeof OPTIONS>,
  write: (text: string) => void,
): Promise<void> {
  if (more.length > 0) throw new ConfigError('Describe one recording at a time.');
  if (repair && path !== undefined) await repairFile(path, write);
  const { file, reader } = await openRecording(path);
  try {
    const { summary } = reader;
    const size = Number(await file.size());
    write(json ? `${jsonText(summary, size)}\n` : plainText(summary, size));
  } finally {
    await file.close();
  }
}

async function repairFile(path: string, write: (text: string) => void): Promise<void> {
  const { reader, file: opened } = await openRecording(path);
  await opened.close();
  if (!reader.summary.isDamaged) return;
  const file = await DiskFile.edit(path);
  try {
    await repairRecording(file);
  } finally {
    await file.close();
  }
  write('Repaired. Records after the last whole chunk are lost: at most one second.\n\n');
}

function plainText(summary: RecordingSummary, size: number): string {
  const { name, kind, masterName, version, notes, startNs, endNs, records, topics } = summary;
  const facts: [string, string][] = [
    ['name', name || 'none'],
    ['kind', summary.isForeign ? 'recording of another program' : kind],
    ['master', masterName],
    ['version', version],
    ['notes', notes],
    ['start', records === 0 ? '' : new Date(Number(startNs / 1_000_000n)).toISOString()],
    ['length', durationText(endNs - startNs)],
    ['size', bytesText(size)],
    ['records', String(records)],
    ['markers', summary.markers.map(({ text }) => text).join(', ')],
    ['attached', summary.foreignParts.attachments.map(({ name }) => name).join(', ')],
    ['missing', missingText(summary)],
  ];
  const width = Math.max(...facts.map(([fact]) => fact.length));
  const lines = facts.flatMap(([fact, text]) => (text ? [`${fact.padEnd(width)}  ${text}`] : []));
  return `${[...lines, '', ...topicLines(topics, endNs - startNs)].join('\n')}\n`;
}

function missingText({ isDamaged, gaps }: RecordingSummary): string {
  const lost = gaps.reduce((sum, gap) => sum + gap.records, 0);
  return [
    isDamaged ? 'the end of the file; repair it with --repair' : '',
    lost > 0 ? `${counted(lost, 'record')}, which were not written in time` : '',
  ]
    .filter(Boolean)
    .join('; ');
}

function topicLines(topics: readonly RecordedTopic[], lengthNs: bigint): string[] {
  const seconds = Number(lengthNs) / 1e9;
  const rows = topics.map(({ topic, format, schemaName, isRaw, clientName, clientId, records }) => [
    topic,
    isRaw ? schemaName : format,
    String(records),
    seconds > 0 ? `${(records / seconds).toFixed(1)} Hz` : '',
    clientName || clientId || 'master',
  ]);
  const table = [['topic', 'format', 'records', 'rate', 'publisher'], ...rows];
  const widths = table[0]!.map((_, column) => Math.max(...table.map((row) => row[column]!.length)));
  return table.map((row) =>
    row
      .map((cell, column) => cell.padEnd(widths[column]!))
      .join('  ')
      .trimEnd(),
  );
}

/** Times in nanoseconds are texts: JSON numbers are not that exact. */
function jsonText(summary: RecordingSummary, sizeBytes: number): string {
  return JSON.stringify(
    { sizeBytes, ...summary },
    (_key, value: unknown) => (typeof value === 'bigint' ? String(value) : value),
    2,
  );
}
