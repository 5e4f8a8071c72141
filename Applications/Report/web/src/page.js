/** @param {string} id @returns {HTMLElement} @throws when the page has no such element */
export function element(id) {
  const found = document.getElementById(id);
  if (!found) {
    throw new Error(`the page has no element ${id}`);
  }
  return found;
}

/** @param {string} id @returns {any} what the data element of this name holds; null when the page has none */
export function pageData(id) {
  const found = document.getElementById(id);
  return found ? JSON.parse(found.textContent) : null;
}

/** Lets the browser save a text as a file. */
export function saveText(name, text, type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** Copies a text, and says whether it did. @param {string} text @param {HTMLElement} state */
export async function copyText(text, state) {
  try {
    await navigator.clipboard.writeText(text);
    state.textContent = "Copied.";
  } catch {
    state.textContent = "The browser does not allow it: select the text and copy it.";
  }
}
