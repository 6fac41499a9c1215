import { DEFAULT_TEXT_LIMITS } from '@ubii/proto';
import { KIB, MIB, limit } from './limit.ts';

const GIB = KIB * MIB;

/** Limits of recordings, of the flight recorder and of replays. */
export const RECORDING_LIMITS = {
  runningRecordings: limit(
    8,
    'recordings',
    'storage',
    'Recordings that run at the same time. Each is compressed and written on its own.',
  ),
  recordings: limit(
    5_000,
    'recordings',
    'storage',
    'Recordings that are kept. The master reads the end of each file when it starts to list them.',
  ),
  recordingsBytes: limit(
    20 * GIB,
    'bytes',
    'storage',
    'Files of all recordings. Beyond it, the master deletes the oldest keepings of the flight recorder, and then stops recording.',
  ),
  recordingsAtNodes: limit(
    200,
    'recordings',
    'storage',
    'Recordings that nodes make, or have not uploaded yet. The master keeps what nodes say of each.',
  ),
  recordingBytes: limit(
    8 * GIB,
    'bytes',
    'storage',
    'File of one recording, at which it stops. A day of a party without images.',
  ),
  recordingMs: limit(86_400_000, 'ms', 'time', 'Duration at which a recording stops.'),
  recordingFreeBytes: limit(
    GIB,
    'bytes',
    'storage',
    'Free space on the disk below which recordings stop, so that other programs can go on.',
  ),
  recordingUploadBytes: limit(8 * GIB, 'bytes', 'storage', 'One uploaded recording.'),
  uploadsPerClient: limit(
    2,
    'uploads',
    'rates',
    'Uploads of recordings of one client, or of one address that needs no token, at the same time. Each is checked on its own when it has arrived.',
  ),
  uploadBytesPerClient: limit(
    8 * GIB,
    'bytes',
    'storage',
    'Bytes of all uploads of one client at the same time. One of the largest uploads.',
  ),
  recordingCheckMs: limit(
    20_000,
    'ms',
    'time',
    'Time in which an uploaded recording is checked, before the connection of its sender is closed as idle. Files that are found at the start get a second more for each 4 MiB, because a repair reads all of them.',
  ),
  recordingCheckBytes: limit(
    640 * MIB,
    'bytes',
    'storage',
    'Heap of the process that checks recordings. The longest index that is read takes 470 MiB of it.',
  ),
  recorderQueueBytes: limit(
    32 * MIB,
    'bytes',
    'queues',
    'Records that wait for their files, those over 16 KiB in half of it, or in the memory of the flight recorder if that is larger. Records beyond are counted as lost.',
  ),
  markersPerRecording: limit(
    10_000,
    'markers',
    'storage',
    'Markers of one recording, with their changes. Each of them is in its list.',
  ),
  personalLabels: limit(
    DEFAULT_TEXT_LIMITS.personalLabels,
    'labels',
    'storage',
    'Labels of personal data. Each topic of a recording that is shared is compared with all of them.',
  ),
  flightRecorderMs: limit(
    3_600_000,
    'ms',
    'storage',
    'Longest time that the flight recorder can be set to keep.',
  ),
  flightRecorderBytes: limit(
    512 * MIB,
    'bytes',
    'storage',
    'Most memory that the flight recorder can be set to keep.',
  ),
  flightReads: limit(
    16,
    'reads',
    'rates',
    'Reads of the flight recorder at the same time. Each looks through all that it holds, one after the other.',
  ),
  flightReadsPerClient: limit(
    2,
    'reads',
    'rates',
    'Reads of the flight recorder of one client at the same time.',
  ),
  flightReadBytes: limit(
    4 * MIB,
    'bytes',
    'rates',
    'Records of one read of the flight recorder: a minute of a topic at 1000 Hz. Each topic has an equal share.',
  ),
  runningReplays: limit(
    4,
    'replays',
    'rates',
    'Replays at the same time. Each reads its file ahead, up to 16 MiB.',
  ),
  replayCopies: limit(
    32,
    'clients',
    'rates',
    'Copies of one ghost. Each of them is a client. Enough for a class of students.',
  ),
  replayRecordsPerSecond: limit(
    50_000,
    'records/s',
    'rates',
    'Records that one replay publishes per second; beyond that, it takes longer. The rate at which the recorder still takes all records.',
  ),
} as const;
