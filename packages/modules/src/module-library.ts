import { fromJson, type ProcessingModule } from '@ubii/proto';
import { LIBRARY } from './generated/library.ts';

/**
 * Returns all modules as new messages with source text and without an id. The text is the same in every
 * bundle, so that a node can recognise the code of its own library in a session. [PM-64]
 */
export function moduleLibrary(): ProcessingModule[] {
  return LIBRARY.map((json) => fromJson('ubii.processing.ProcessingModule', json));
}
