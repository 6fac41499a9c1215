export { capitalised } from './capitalised.ts';
export { csvField } from './csv-field.ts';
export { counted, plural } from './plural.ts';
