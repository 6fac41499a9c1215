export { capitalised } from './capitalised.ts';
export { counted, plural } from './plural.ts';
