export { capitalised } from './capitalised.ts';
export { csvField } from './csv-field.ts';
export { isOneLine, oneLine } from './one-line.ts';
export { counted, plural } from './plural.ts';
export { firstCharacters, hasMoreCharacters, isLongerThan, shortened } from './text-length.ts';
