import type { Entrance } from '../entrance.ts';
import { files, sessionFiles } from './files.ts';
import { http, join } from './http.ts';
import { csv, xdf } from './imports.ts';
import { codec, jsonCodec } from './parsers.ts';
import { pictures } from './pictures.ts';
import { recordingFiles, uploads } from './recordings.ts';
import { binary, json } from './services.ts';
import { start } from './start.ts';
import { frames, preflight, topicData } from './websocket.ts';

/** Every entrance of bytes. */
export const ENTRANCES: readonly Entrance[] = [
  ...[http, json, binary, topicData, frames, preflight, join, files, uploads, start],
  ...[codec, jsonCodec, recordingFiles, csv, xdf, sessionFiles, pictures],
];
