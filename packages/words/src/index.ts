export {
  capitalised,
  counted,
  plural,
  firstCharacters,
  hasMoreCharacters,
  isLongerThan,
  shortened,
  isOneLine,
  oneLine,
  csvField,
} from './words.ts';
