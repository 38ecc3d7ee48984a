/** Saves a file where the browser saves files. */
export function save(name, content) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([content]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** Copies a text and says so on the button for a while. */
export async function copy(button, text) {
    const label = button.textContent;
    try {
        await navigator.clipboard.writeText(text);
        button.textContent = 'Copied';
    } catch {
        button.textContent = 'Not allowed here';
    }
    setTimeout(() => {
        button.textContent = label;
    }, 1500);
}
