import { MAX_CHOICE_CHARACTERS, MAX_IO_DESCRIPTION_CHARACTERS } from '@ubii/pm-sandbox';
import { DEFAULT_TEXT_LIMITS } from '@ubii/proto';
import { KIB, limit } from './limit.ts';

/** Limits of texts from clients, and of the log. */
export const TEXT_LIMITS = {
  idCharacters: limit(
    DEFAULT_TEXT_LIMITS.idCharacters,
    'characters',
    'texts',
    'Id of a client, device, component, session, module or invitation. Ids of the master have 36 characters; existing programs create ids in their own formats.',
  ),
  identifierCharacters: limit(
    DEFAULT_TEXT_LIMITS.identifierCharacters,
    'characters',
    'texts',
    'Name of a session, module, component, input, output, muxer or data format. Longer names are refused.',
  ),
  nameCharacters: limit(
    DEFAULT_TEXT_LIMITS.nameCharacters,
    'characters',
    'texts',
    'Name of a client or device, label of an invitation, or author. Events, the log and pages show these names. Longer names of clients and devices are cut.',
  ),
  tagCharacters: limit(100, 'characters', 'texts', 'One tag.'),
  textsPerList: limit(
    DEFAULT_TEXT_LIMITS.textsPerList,
    'texts',
    'texts',
    'Tags, authors or libraries of one session, module, device or client, or choices of an input. A handful is usual.',
  ),
  descriptionCharacters: limit(
    DEFAULT_TEXT_LIMITS.descriptionCharacters,
    'characters',
    'texts',
    'Description, about two pages of text. Longer descriptions of clients, devices and components are cut, those of sessions and modules refused.',
  ),
  ioDescriptionCharacters: limit(
    MAX_IO_DESCRIPTION_CHARACTERS,
    'characters',
    'texts',
    'Description of an input or output of a module, one sentence. Longer ones are refused.',
  ),
  choiceCharacters: limit(
    MAX_CHOICE_CHARACTERS,
    'characters',
    'texts',
    'One of the texts that an input of a module understands. Longer ones are refused.',
  ),
  reasonCharacters: limit(
    200,
    'characters',
    'texts',
    'Reason for an action on a client, one sentence. Cut when longer.',
  ),
  pathCharacters: limit(301, 'characters', 'texts', 'Path of the page that opens after joining.'),
  libraryCharacters: limit(
    64,
    'characters',
    'texts',
    'Library version, address and node libraries that a client reports. Cut when longer.',
  ),
  userAgentCharacters: limit(
    256,
    'characters',
    'texts',
    'User agent of a browser. Cut when longer.',
  ),
  secretCharacters: limit(
    1_024,
    'characters',
    'texts',
    'Token or code of a caller. Tokens have about 100 characters; longer ones are refused.',
  ),
  jsonCharacters: limit(
    65_536,
    'characters',
    'texts',
    'Metadata of a client, or constant of a session, as JSON.',
  ),
  eventCharacters: limit(
    DEFAULT_TEXT_LIMITS.eventCharacters,
    'characters',
    'texts',
    'Event or problem in the status of the master, which keeps 200 events. Cut when longer.',
  ),
  logCharacters: limit(
    1_000,
    'characters',
    'texts',
    'Message of a log line, or one of its values, of which it has at most 20. Cut when longer.',
  ),
  stackCharacters: limit(
    8_192,
    'characters',
    'texts',
    'Stack trace of an internal error in the log. Cut when longer.',
  ),
  logBytesPerSecond: limit(
    32 * KIB,
    'bytes/s',
    'texts',
    'Average rate of log lines. After a start or a quiet period, bursts of up to 30 s of this rate are logged. Further lines are dropped and counted.',
  ),
} as const;
