import { fromJson, type ProcessingModule } from '@ubii/proto';
import { LIBRARY } from './generated/library.ts';

/**
 * All modules as messages with source text, complete and without an id; the caller's to change. The
 * text is the same in every program, however it is bundled: that is how a node knows that the code a
 * session brings is its own. [PM-64]
 */
export function moduleLibrary(): ProcessingModule[] {
  return LIBRARY.map((json) => fromJson('ubii.processing.ProcessingModule', json));
}
